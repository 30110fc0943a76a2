using UnityEngine;

namespace Alate
{
    /// <summary>Mesh with the blend shapes of its renderer at their current weights.</summary>
    internal sealed class BlendedShape
    {
        public readonly Vector3[] positions;
        public readonly Vector3[] normals;
        public readonly Vector4[] tangents;

        public BlendedShape(Mesh mesh, SkinnedMeshRenderer renderer)
        {
            positions = mesh.vertices;
            normals = mesh.normals;
            tangents = mesh.tangents;
            for (int shape = 0; shape < mesh.blendShapeCount; shape++)
            {
                float weight = renderer.GetBlendShapeWeight(shape);
                if (weight != 0f)
                    Blend(mesh, shape, weight);
            }
        }

        // Between two frames their differences are mixed; before the first they grow from nothing, behind the last they stay.
        private void Blend(Mesh mesh, int shape, float weight)
        {
            int frames = mesh.GetBlendShapeFrameCount(shape);
            int next = 0;
            while (next < frames - 1 && mesh.GetBlendShapeFrameWeight(shape, next) < weight)
                next++;
            float end = mesh.GetBlendShapeFrameWeight(shape, next);
            float start = next > 0 ? mesh.GetBlendShapeFrameWeight(shape, next - 1) : 0f;
            float share = end != start ? Mathf.Min((weight - start) / (end - start), 1f) : 1f;
            Add(mesh, shape, next, share);
            if (next > 0 && share < 1f)
                Add(mesh, shape, next - 1, 1f - share);
        }

        private void Add(Mesh mesh, int shape, int frame, float share)
        {
            var moves = new Vector3[mesh.vertexCount];
            var turns = new Vector3[mesh.vertexCount];
            var tangentTurns = new Vector3[mesh.vertexCount];
            mesh.GetBlendShapeFrameVertices(shape, frame, moves, turns, tangentTurns);
            for (int vertex = 0; vertex < positions.Length; vertex++)
            {
                positions[vertex] += share * moves[vertex];
                if (normals.Length > 0)
                    normals[vertex] += share * turns[vertex];
                if (tangents.Length > 0)
                    tangents[vertex] += share * (Vector4)tangentTurns[vertex];
            }
        }
    }
}
