using System;
using Alate.Catalogue;
using Unity.StandIns;
using UnityEngine;

namespace Alate.Benchmarks;

/// <summary>Monarchs with one mesh, skeleton and material a side, which live.</summary>
internal sealed class Brood
{
    private static readonly WingSide[] s_Sides = [WingSide.Right, WingSide.Left];

    private readonly WingSkinning m_Skinning;
    private readonly Mesh[] m_Meshes;
    private readonly WingSkeleton[] m_Skeletons;
    private readonly Material m_Material;

    /// <param name="skinning">What deforms their meshes.</param>
    public Brood(WingSkinning skinning)
    {
        m_Skinning = skinning;
        WingDefinition kind = InsectCatalogue.Find("monarch").Wings[0];
        m_Meshes = Array.ConvertAll(s_Sides, side => kind.CreateSurface(side).ToMesh($"monarch {side}"));
        m_Skeletons = Array.ConvertAll(s_Sides, side => kind.CreateSkeleton(side));
        ProjectShaders.Add(WingMaterial.ShaderName, WingMaterial.ShaderName);
        m_Material = new Material(Shader.Find(WingMaterial.ShaderName));
    }

    /// <summary>Makes one, which starts to live.</summary>
    public void Hatch(int number, Vector3 place)
    {
        var root = new GameObject($"monarch {number}");
        root.SetActive(false);
        root.transform.position = place;
        InsectWings insect = root.AddComponent<InsectWings>();
        foreach (WingSide side in s_Sides)
        {
            var wing = new GameObject($"wing {side}", typeof(MeshFilter), typeof(MeshRenderer));
            wing.transform.SetParent(root.transform, false);
            wing.GetComponent<MeshFilter>().sharedMesh = m_Meshes[(int)side];
            wing.GetComponent<MeshRenderer>().sharedMaterial = m_Material;
            insect.Wings.Add(new Wing { Renderer = wing.GetComponent<MeshRenderer>(), Side = side, Skeleton = m_Skeletons[(int)side] });
        }

        insect.Quality.culling = WingCulling.AlwaysSimulate;
        insect.Quality.skinning = m_Skinning;
        root.SetActive(true);
    }
}
