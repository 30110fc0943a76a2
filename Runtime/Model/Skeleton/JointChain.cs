using System;
using UnityEngine;
using UnityEngine.Scripting.APIUpdating;

namespace Alate
{
    /// <summary>One chain of joints of a <see cref="WingSkeleton"/>, radiating from the wing's base.</summary>
    [Serializable]
    [MovedFrom(true, null, "Alate")]
    public struct JointChain
    {
        /// <summary>Rest positions from root to tip, mesh space.</summary>
        public Vector3[] joints;

        /// <summary>A chain of these joints.</summary>
        /// <param name="joints">Rest positions from root to tip, mesh space; kept, not copied.</param>
        public JointChain(params Vector3[] joints)
        {
            this.joints = joints;
        }

        /// <summary>Joints of the chain; 0 when there is no array.</summary>
        public int Length => joints?.Length ?? 0;
    }
}
