namespace Alate.Editor
{
    /// <summary>Surface along which dragged joints move.</summary>
    internal enum DragMode
    {
        /// <summary>Plane of the wing through the grabbed joint; the height above the wing stays.</summary>
        WingPlane,

        /// <summary>Plane of the screen through the grabbed joint.</summary>
        Free,

        /// <summary>Wing's mesh: the grabbed joint follows the pointer, the others move to the points closest to them.</summary>
        Surface,

        /// <summary>Chains of the joints.</summary>
        Chain,
    }
}
