using System.Collections.Generic;
using UnityEngine;

namespace Alate
{
    /// <summary>Meaning of the names around a renderer: its own, its mesh's, those of its parents and of its materials.</summary>
    internal sealed class RendererNames
    {
        private readonly List<Material> m_Materials = new List<Material>();

        public RendererNames(Renderer renderer, Mesh mesh, Transform root)
        {
            renderer.GetSharedMaterials(m_Materials);
            Add(WingName.Read(renderer.name), true);
            Add(WingName.Read(mesh.name), true);
            for (Transform place = renderer.transform; place != root && place.parent != root && place.parent != null; place = place.parent)
                Add(WingName.Read(place.parent.name), false);
        }

        /// <summary>True where the renderer as a whole is named a wing, or lies below an object that is named only that.</summary>
        public bool IsWing { get; private set; }

        /// <summary>True where the renderer is named a wing's cover, or lies below one.</summary>
        public bool IsCase { get; private set; }

        /// <summary>Side given by the nearest name that has one.</summary>
        public WingSide? Side { get; private set; }

        /// <summary>Pair given by the nearest name that has one.</summary>
        public WingPair? Pair { get; private set; }

        /// <summary>Meaning of the name of a submesh's material; empty if there is none.</summary>
        public WingName Material(int submesh) =>
            WingName.Read(submesh < m_Materials.Count && m_Materials[submesh] != null ? m_Materials[submesh].name : null);

        private void Add(WingName name, bool isOwn)
        {
            IsWing |= isOwn ? name.IsWing : name.IsPlainWing;
            IsCase |= name.IsCase;
            Side = Side ?? name.Side;
            Pair = Pair ?? name.Pair;
        }
    }
}
