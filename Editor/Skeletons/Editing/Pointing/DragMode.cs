using Alate.Fitting;

namespace Alate.Editor
{
    /// <summary>Where dragged joints go.</summary>
    internal enum DragMode
    {
        /// <summary>Within the plane of the wing through the grabbed joint; the height above the wing stays.</summary>
        WingPlane,

        /// <summary>Within the plane of the screen through the grabbed joint.</summary>
        Free,

        /// <summary>Over the wing's mesh: the grabbed joint under the pointer, the others to the points closest to them.</summary>
        Surface,

        /// <summary>Along their own chains.</summary>
        Chain,
    }
}
