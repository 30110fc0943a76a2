using System.Collections.Generic;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>One weakness of a rig, where it lies, and which joints to look at.</summary>
    internal readonly struct RigProblem
    {
        public RigProblem(RigProblemKind kind, Vector3 position, IReadOnlyList<JointIndex> joints, string message)
        {
            Kind = kind;
            Position = position;
            Joints = joints;
            Message = message;
        }

        public RigProblemKind Kind { get; }

        /// <summary>Mesh space.</summary>
        public Vector3 Position { get; }

        /// <summary>The joints to select.</summary>
        public IReadOnlyList<JointIndex> Joints { get; }

        /// <summary>One sentence for the user.</summary>
        public string Message { get; }

        public override string ToString() => Message;
    }
}
