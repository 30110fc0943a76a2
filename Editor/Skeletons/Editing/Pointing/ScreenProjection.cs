using UnityEngine;

namespace Alate.Editor
{
    /// <summary>
    /// Projects a point of the world to the screen: x and y in pixels, z its distance ahead of the eye, not positive behind it.
    /// </summary>
    internal delegate Vector3 ScreenProjection(Vector3 worldPoint);
}
