using System;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Alate.Samples
{
    /// <summary>One wing of the sample: an object with a mesh of its own, and its place in the <see cref="WingWorld"/>.</summary>
    internal sealed class MonarchWing : IDisposable
    {
        // Stream 0 is laid out as SkinnedVertex, so that a whole wing is copied at once; colours never change and have a stream to themselves.
        private static readonly VertexAttributeDescriptor[] s_Layout =
        {
            new VertexAttributeDescriptor(VertexAttribute.Position, VertexAttributeFormat.Float32, 3, 0),
            new VertexAttributeDescriptor(VertexAttribute.Normal, VertexAttributeFormat.Float32, 3, 0),
            new VertexAttributeDescriptor(VertexAttribute.Color, VertexAttributeFormat.UNorm8, 4, 1),
        };

        private const MeshUpdateFlags k_Unchecked =
            MeshUpdateFlags.DontValidateIndices | MeshUpdateFlags.DontResetBoneBounds | MeshUpdateFlags.DontRecalculateBounds;

        private readonly WingWorld m_World;
        private readonly WingHandle m_Handle;
        private readonly WingFrame m_Frame;
        private readonly WingSide m_Side;
        private readonly float m_Length;
        private readonly Mesh m_Mesh;

        public MonarchWing(
            WingWorld world, WingRig rig, SpeciesWing wing, SurfaceMesh surface, WingSpecies species, WingSide side, Material material, Transform body)
        {
            m_World = world;
            m_Handle = world.Add(rig, species.ToParameters());
            m_Frame = rig.Frame;
            m_Side = side;
            m_Length = species.WingLength;
            m_Mesh = CreateMesh(surface, $"{side} wing");
            Transform place = CreateObject(m_Mesh.name, m_Mesh, material, body).transform;
            place.localPosition = wing.HingeOn(side);
            place.localScale = new Vector3(side == WingSide.Right ? 1f : -1f, 1f, 1f);
        }

        /// <summary>A child with a mesh.</summary>
        public static GameObject CreateObject(string name, Mesh mesh, Material material, Transform parent)
        {
            var made = new GameObject(name);
            made.transform.SetParent(parent, false);
            made.AddComponent<MeshFilter>().sharedMesh = mesh;
            made.AddComponent<MeshRenderer>().sharedMaterial = material;
            return made;
        }

        public void SetParameters(in WingParameters parameters) => m_World.SetParameters(m_Handle, parameters);

        /// <summary>Tells the wing of air (m/s) and gravity (m/s²) in the body's axes, the body's speed (m/s) and its pitch (radians).</summary>
        public void Feel(Vector3 air, Vector3 gravity, float speed, float pitch)
        {
            m_World.SetSurroundings(m_Handle, new WingSurroundings
            {
                wind = ToWing(air) / m_Length,
                gravity = ToWing(gravity) / m_Length,
                speed = speed,
                angleOfAttack = pitch,
            });
        }

        /// <summary>Copies what the world skinned last into the mesh.</summary>
        public void Show()
        {
            m_Mesh.SetVertexBufferData(m_World.Vertices(m_Handle), 0, 0, m_Mesh.vertexCount, 0, k_Unchecked);
            m_Mesh.bounds = m_World.Bounds(m_Handle);
        }

        /// <summary>Frees the mesh; the object goes with the body, the wing with its world.</summary>
        public void Dispose() => UnityEngine.Object.Destroy(m_Mesh);

        private float3 ToWing(Vector3 ofBody)
        {
            float mirror = m_Side == WingSide.Right ? 1f : -1f;
            return m_Frame.DirectionToWing(new float3(mirror * ofBody.x, ofBody.y, ofBody.z));
        }

        private static Mesh CreateMesh(SurfaceMesh surface, string name)
        {
            var rest = new SkinnedVertex[surface.VertexCount];
            for (int k = 0; k < rest.Length; k++)
                rest[k] = new SkinnedVertex { position = surface.positions[k], normal = surface.normals[k] };
            var mesh = new Mesh { name = name };
            mesh.MarkDynamic();
            mesh.SetVertexBufferParams(rest.Length, s_Layout);
            mesh.SetVertexBufferData(rest, 0, 0, rest.Length, 0);
            mesh.SetVertexBufferData(surface.colours, 0, 0, rest.Length, 1);
            mesh.triangles = surface.triangles;
            mesh.RecalculateBounds();
            return mesh;
        }
    }
}
