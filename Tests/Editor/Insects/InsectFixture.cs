using System.Collections.Generic;
using Alate.Catalogue;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor.Tests
{
    /// <summary>Makes insects in the editor, and takes everything away after each test.</summary>
    public abstract class InsectFixture
    {
        private readonly List<Object> m_Made = new List<Object>();
        private readonly List<string> m_Assets = new List<string>();

        [TearDown]
        public void TakeAllAway()
        {
            foreach (string path in m_Assets)
                AssetDatabase.DeleteAsset(path);
            foreach (Object made in m_Made)
            {
                if (made != null)
                    Object.DestroyImmediate(made);
            }

            m_Assets.Clear();
            m_Made.Clear();
            Undo.ClearAll();
        }

        /// <summary>Destroyed at the end of the test.</summary>
        protected T Keep<T>(T made) where T : Object
        {
            m_Made.Add(made);
            return made;
        }

        /// <summary>A path in the project whose asset is deleted at the end of the test.</summary>
        protected string PathFor(string name)
        {
            string path = $"Assets/Alate Test {name}.asset";
            m_Assets.Add(path);
            return path;
        }

        /// <summary>A monarch's two wings under a root, without the component.</summary>
        protected GameObject Bare()
        {
            GameObject root = Keep(new GameObject("insect"));
            AddWing(root, WingSide.Right);
            AddWing(root, WingSide.Left);
            return root;
        }

        /// <summary>An insect with these wings in its list, each with its skeleton.</summary>
        protected InsectWings Insect()
        {
            InsectWings insect = Without(Bare());
            foreach (MeshRenderer renderer in insect.GetComponentsInChildren<MeshRenderer>())
                insect.Wings.Add(WingOf(renderer));
            return insect;
        }

        /// <summary>Adds the component with an empty list.</summary>
        protected static InsectWings Without(GameObject root)
        {
            InsectWings insect = root.AddComponent<InsectWings>();
            insect.Wings.Clear();
            return insect;
        }

        /// <summary>An entry for one of the monarch's wings.</summary>
        protected Wing WingOf(MeshRenderer renderer)
        {
            WingSide side = renderer.name.EndsWith("Left") ? WingSide.Left : WingSide.Right;
            WingSkeleton skeleton = Keep(Monarch.CreateSkeleton(side));
            skeleton.name = "skeleton " + side;
            return new Wing { Renderer = renderer, Side = side, Skeleton = skeleton };
        }

        protected static WingDefinition Monarch => InsectCatalogue.Find("monarch").Wings[0];

        protected static Mesh MeshOf(Wing wing) => wing.Renderer.GetComponent<MeshFilter>().sharedMesh;

        private void AddWing(GameObject root, WingSide side)
        {
            var wing = new GameObject("wing " + side);
            wing.transform.SetParent(root.transform, false);
            wing.transform.localPosition = Monarch.HingeOn(side);
            wing.AddComponent<MeshFilter>().sharedMesh = Keep(Monarch.CreateSurface(side).ToMesh("wing " + side));
            wing.AddComponent<MeshRenderer>();
        }
    }
}
