using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>The colour of a place on a body, alpha being how little light passes: 255 is solid.</summary>
    internal delegate Color32 BodyPaint(in BodyPoint point);
}
