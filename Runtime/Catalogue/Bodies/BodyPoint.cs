using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>The colour of a place on a body, alpha being how little light passes: 255 is solid.</summary>
    internal delegate Color32 BodyPaint(in BodyPoint point);

    /// <summary>Point on the right side of a body, as passed to its colouring.</summary>
    internal readonly struct BodyPoint
    {
        public BodyPoint(Vector3 place, Vector3 normal, Vector2 uv)
        {
            Place = place;
            Normal = normal;
            Around = uv.x;
            Along = uv.y;
        }

        /// <summary>Millimetres; x is 0 or positive.</summary>
        public Vector3 Place { get; }

        /// <summary>Outwards, unit length.</summary>
        public Vector3 Normal { get; }

        /// <summary>Round the part: 0 on its upper line, 1 on its lower one.</summary>
        public float Around { get; }

        /// <summary>Place along the part: 0 at its beginning, 1 at its end.</summary>
        public float Along { get; }
    }
}
