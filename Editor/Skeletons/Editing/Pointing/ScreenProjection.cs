using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Where a point of the world is seen: x and y in pixels, z its distance ahead of the eye, not positive behind it.</summary>
    internal delegate Vector3 ScreenProjection(Vector3 worldPoint);
}
