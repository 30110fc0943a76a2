using System.Collections.Generic;
using UnityEngine;

namespace Alate
{
    /// <summary>Lists the parts of a renderer's mesh that may each be one wing.</summary>
    internal sealed class WingCandidates
    {
        private readonly Renderer m_Renderer;
        private readonly RendererNames m_Names;
        private readonly MeasuredMesh m_Mesh;
        private readonly List<WingCandidate> m_Found = new List<WingCandidate>();

        private WingCandidates(Renderer renderer, Mesh mesh, Transform root)
        {
            m_Renderer = renderer;
            m_Names = new RendererNames(renderer, mesh, root);
            Matrix4x4 toWorld = renderer is SkinnedMeshRenderer skinned
                ? SkinnedPose.ToWorld(skinned)
                : renderer.transform.localToWorldMatrix;
            m_Mesh = new MeasuredMesh(mesh, root.worldToLocalMatrix * toWorld);
        }

        /// <summary>Lists the parts of a renderer that may be wings, marked where names call them so; none of a wing case.</summary>
        public static List<WingCandidate> Of(Renderer renderer, Mesh mesh, Transform root)
        {
            var candidates = new WingCandidates(renderer, mesh, root);
            if (!candidates.m_Names.IsCase)
                candidates.Collect();
            return candidates.m_Found;
        }

        private void Collect()
        {
            var drawn = new List<int>();
            for (int submesh = 0; submesh < m_Mesh.SubmeshCount; submesh++)
            {
                if (m_Mesh.IsDrawn(submesh))
                    drawn.Add(submesh);
            }

            if (drawn.Count == 0)
                return;
            List<int> wings = m_Names.IsWing ? drawn : drawn.FindAll(submesh => m_Names.Material(submesh).IsWing);
            if (wings.Count < drawn.Count && wings.Count > 0)
                CollectSubmeshes(wings);
            else
                CollectAll(drawn, wings.Count > 0);
        }

        /// <summary>Collects candidates of a mesh that is all wing, or of which nothing is known.</summary>
        private void CollectAll(List<int> drawn, bool isNamed)
        {
            WingShape whole = m_Mesh.Whole();
            List<(WingShape shape, Vector3 point, int submesh)> pieces = Pieces(-1, isNamed && whole.Side == null);
            if (whole.Side == null || WingGroup.Count(pieces) > 1)
            {
                if (drawn.Count > 1 && whole.Side == null && AreWings(drawn, isNamed))
                    drawn.ForEach(submesh => Add(WingPart.Submesh, submesh, default, m_Mesh.Submesh(submesh), isNamed));
                else
                    AddPieces(pieces, isNamed);
            }

            if (m_Found.Count == 0 && whole.Side != null && (isNamed || whole.isSheet))
                Add(WingPart.WholeMesh, 0, default, whole, isNamed);
        }

        /// <summary>Collects the submeshes whose materials are named wings.</summary>
        private void CollectSubmeshes(List<int> wings)
        {
            foreach (int submesh in wings)
            {
                WingShape shape = m_Mesh.Submesh(submesh);
                List<(WingShape shape, Vector3 point, int submesh)> pieces = Pieces(submesh, shape.Side == null);
                if (shape.Side != null && WingGroup.Count(pieces) < 2)
                    Add(WingPart.Submesh, submesh, default, shape, true);
                else
                    AddPieces(pieces, true);
            }
        }

        private List<(WingShape shape, Vector3 point, int submesh)> Pieces(int submesh, bool guess)
        {
            if (!m_Mesh.IsReadable)
                return guess ? m_Mesh.Halves(submesh) : new List<(WingShape shape, Vector3 point, int submesh)>();
            return submesh < 0 ? m_Mesh.Sheets() : m_Mesh.Sheets().FindAll(piece => piece.submesh == submesh);
        }

        // Each submesh is a wing of one side; of a mesh on both sides there is one on either.
        private bool AreWings(List<int> submeshes, bool isNamed) =>
            submeshes.ConvertAll(m_Mesh.Submesh).TrueForAll(shape => shape.Side != null && (isNamed || shape.isSheet));

        private void AddPieces(List<(WingShape shape, Vector3 point, int submesh)> pieces, bool isNamed) =>
            pieces.ForEach(piece => Add(WingPart.ConnectedPart, piece.submesh, piece.point, piece.shape, isNamed));

        private void Add(WingPart part, int submesh, Vector3 point, WingShape shape, bool isNamed)
        {
            WingName material = submesh < 0 ? default : m_Names.Material(submesh);
            m_Found.Add(new WingCandidate
            {
                renderer = m_Renderer,
                part = part,
                submesh = part == WingPart.Submesh ? submesh : 0,
                point = point,
                shape = shape,
                isNamed = isNamed,
                namedSide = m_Names.Side ?? material.Side,
                pair = m_Names.Pair ?? material.Pair,
            });
        }
    }
}
