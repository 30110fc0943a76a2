namespace Alate
{
    /// <summary>Wings whose joints have a place in the texture.</summary>
    internal interface IJointOwner
    {
        /// <summary>Lets the jobs write the joints of all wings into the texture.</summary>
        void PlaceJoints(WingWorld world);
    }
}
