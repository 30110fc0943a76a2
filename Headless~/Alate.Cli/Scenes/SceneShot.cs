using UnityEngine;

namespace Alate.Cli;

/// <summary>All that a picture of a scene is made of, which no longer changes.</summary>
/// <param name="Camera">Who looks.</param>
/// <param name="Surfaces">What there is.</param>
/// <param name="Light">The light on it.</param>
/// <param name="Behind">Linear light of what is behind all.</param>
internal sealed record SceneShot(SceneCamera Camera, IReadOnlyList<SceneSurface> Surfaces, SceneLight Light, float3 Behind)
{
    /// <summary>Paints the picture, rows from above. Any thread may.</summary>
    public Color32[] Paint() => ScenePicture.Paint(Camera, Surfaces, Light, Behind);
}
