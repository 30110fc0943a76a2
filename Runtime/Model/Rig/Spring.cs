using UnityEngine.Scripting.APIUpdating;

namespace Alate
{
    /// <summary>A spring of the elastic network (Eq. 12) between two joints, by joint index.</summary>
    [MovedFrom(true, null, "Alate")]
    public struct Spring
    {
        /// <summary>One joint.</summary>
        public int a;

        /// <summary>The other joint, of higher index.</summary>
        public int b;

        /// <summary>Rest length, wing lengths.</summary>
        public float length;
    }
}
