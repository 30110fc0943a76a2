namespace Alate
{
    /// <summary>
    /// Place between two neighbouring chains where bending apart would tear the membrane: between a joint of one chain and its foot on the
    /// other.
    /// </summary>
    internal struct Strip
    {
        /// <summary>First bone of the joint's chain.</summary>
        public int bone;

        /// <summary>Number of bones of that chain up to the joint.</summary>
        public int bones;

        /// <summary>First bone of the other chain.</summary>
        public int other;

        /// <summary>Number of bones of the other chain up to the foot.</summary>
        public int others;

        /// <summary>
        /// Index of the strip's first lever: one for each bone of the joint's chain, then one for each of the other chain. The strip's
        /// slope is the sum of levers times bends.
        /// </summary>
        public int lever;
    }
}
