using System.Collections.Generic;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Weakness of a rig, with its place and the joints to look at.</summary>
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

        /// <summary>Position of the weakness, mesh space.</summary>
        public Vector3 Position { get; }

        /// <summary>Joints to select.</summary>
        public IReadOnlyList<JointIndex> Joints { get; }

        /// <summary>Sentence for the user.</summary>
        public string Message { get; }

        public override string ToString() => Message;
    }
}
