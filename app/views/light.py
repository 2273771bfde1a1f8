"""Soft light from above the front left corner."""

import viser


def add_lights(scene: viser.SceneApi) -> None:
    """Replace viser's lights, which bleach a table that is seen from above.

    Neither an environment map nor cast shadows: on a computer without a GPU they are most of the
    cost of a frame, and shadows would not fall on draped fields (see `app.views.shadows`).
    """
    scene.configure_default_lights(enabled=False)
    scene.configure_environment_map(None)
    scene.add_light_hemisphere(
        "/lights/sky", sky_color=(255, 255, 255), ground_color=(190, 190, 200), intensity=2.25
    )
    scene.add_light_directional("/lights/sun", intensity=1.3, position=(-1.2, -1.6, 3.0))
