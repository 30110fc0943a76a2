using UnityEngine;

namespace Alate
{
    /// <summary>An ellipsoid where a species has no body of its own yet.</summary>
    static class PlaceholderBody
    {
        static readonly Color32 s_Colour = new Color32(58, 52, 46, 255);

        /// <summary>A body of the given half axes, millimetres, around the middle of the thorax.</summary>
        public static InsectBody Create(float right, float up, float ahead)
        {
            return new InsectBody(new[] { TubePart.Ellipsoid(Vector3.zero, new Vector3(right, up, ahead), 14, 16, _ => s_Colour) });
        }
    }
}
