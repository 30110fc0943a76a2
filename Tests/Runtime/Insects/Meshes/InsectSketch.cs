using System;
using System.Collections.Generic;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Alate.Tests
{
    /// <summary>A little insect of game objects with meshes of its own, all of which end with it.</summary>
    public sealed class InsectSketch : IDisposable
    {
        private readonly List<Object> m_Made = new List<Object>();

        public InsectSketch()
        {
            Root = new GameObject("Insect").transform;
            Root.SetPositionAndRotation(new Vector3(3f, -2f, 5f), Quaternion.Euler(10f, 70f, -20f));
        }

        public Transform Root { get; }

        /// <summary>A child that draws a mesh, with a material a submesh.</summary>
        /// <param name="path">Names of parents, made where they lack, and of the object, with slashes between.</param>
        public MeshRenderer Draw(string path, MeshSketch sketch, params string[] materials) =>
            Draw(path, sketch.ToMesh("Mesh"), materials.Length > 0 ? materials : new[] { "Default" });

        /// <summary>Draws the output of a generator.</summary>
        public MeshRenderer Draw(string path, SurfaceMesh surface) => Draw(path, surface.ToMesh("Mesh"), new[] { "Default" });

        /// <summary>A child without a mesh.</summary>
        public Transform Place(string path)
        {
            Transform place = Root;
            foreach (string name in path.Split('/'))
            {
                Transform child = place.Find(name);
                if (child == null)
                {
                    child = new GameObject(name).transform;
                    child.SetParent(place, false);
                }

                place = child;
            }

            return place;
        }

        /// <summary>A body of a box and three pairs of legs.</summary>
        public MeshSketch Body()
        {
            MeshSketch body = new MeshSketch().Box(new Vector3(0f, 0f, -0.3f), new Vector3(0.2f, 0.2f, 1.2f));
            for (int leg = 0; leg < 3; leg++)
            {
                foreach (float side in new[] { 1f, -1f })
                    body.Box(new Vector3(0.4f * side, -0.2f, 0.2f - 0.2f * leg), new Vector3(0.6f, 0.03f, 0.03f));
            }

            return body;
        }

        public Mesh Mesh(MeshSketch sketch) => Kept(sketch.ToMesh("Mesh"));

        public Material Material(string name) => Kept(new Material(Shader.Find("Standard")) { name = name });

        public void Dispose()
        {
            if (Root != null)
                Object.DestroyImmediate(Root.gameObject);
            m_Made.ForEach(Object.DestroyImmediate);
        }

        private MeshRenderer Draw(string path, Mesh mesh, string[] materials)
        {
            MeshRenderer renderer = Place(path).gameObject.AddComponent<MeshRenderer>();
            renderer.gameObject.AddComponent<MeshFilter>().sharedMesh = Kept(mesh);
            renderer.sharedMaterials = Array.ConvertAll(materials, Material);
            return renderer;
        }

        private T Kept<T>(T made) where T : Object
        {
            m_Made.Add(made);
            return made;
        }
    }
}
