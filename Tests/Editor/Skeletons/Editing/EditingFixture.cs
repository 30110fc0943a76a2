using System.Collections.Generic;
using Alate.Catalogue;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    /// <summary>
    /// A monarch's right wing under edit, five chains of five joints, mesh units; with its surface and the left wing at hand.
    /// </summary>
    public abstract class EditingFixture
    {
        private readonly List<Object> m_Made = new List<Object>();
        private SnapshotUndo m_Undo;

        private protected WingSkeleton Skeleton { get; private set; }

        private protected WingSkeleton Left { get; private set; }

        private protected SkeletonEditing Editing { get; private set; }

        private protected SnapshotUndo Undo => m_Undo;

        [SetUp]
        public void Begin()
        {
            m_Undo = new SnapshotUndo();
            Skeleton = Keep(Monarch(WingSide.Right));
            Skeleton.name = "Right Wing";
            Left = Keep(Monarch(WingSide.Left));
            Left.name = "Left Wing";
            Editing = Edit(Skeleton);
            Editing.Surface = new SnapSurface(Surface());
            Editing.Twin = new SkeletonTwin(Left, SkeletonMirror.AcrossX);
        }

        [TearDown]
        public void Clear()
        {
            foreach (Object made in m_Made)
                Object.DestroyImmediate(made);
            m_Made.Clear();
        }

        private protected static WingSkeleton Monarch(WingSide side) => InsectCatalogue.Find("monarch").Wings[0].CreateSkeleton(side);

        private protected static SurfaceMesh Surface() =>
            InsectCatalogue.Find("monarch").Wings[0].CreateSurface(WingSide.Right);

        private protected SkeletonEditing Edit(WingSkeleton skeleton) => new SkeletonEditing(Keep(JointSelection.Create(skeleton)), m_Undo);

        private protected T Keep<T>(T made) where T : Object
        {
            m_Made.Add(made);
            return made;
        }

        private protected void Select(params (int chain, int joint)[] joints) =>
            Editing.Select(System.Array.ConvertAll(joints, at => new JointIndex(at.chain, at.joint)));

        private protected EditOutcome Do(string command) => SkeletonCommands.Find(command).Run(Editing);
    }
}
