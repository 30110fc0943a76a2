using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>Colour of a point of a body; alpha is opacity, 255 solid, less lets light through.</summary>
    internal delegate Color32 BodyPaint(in BodyPoint point);
}
