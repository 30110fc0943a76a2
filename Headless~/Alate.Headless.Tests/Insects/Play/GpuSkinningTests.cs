using System;
using System.Collections;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Unity.Mathematics;
using Unity.StandIns;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play.Headless;

/// <summary>
/// Wings that the graphics card deforms: what the shader would make of texture, mesh and properties, by the formula written down a second
/// time, beside a twin that the processor deforms; and what is given back.
/// </summary>
public sealed class GpuSkinningTests : GpuFixture
{
    [UnityTest]
    public IEnumerator TheShader_FindsEachVertex_WhereTheProcessorPutsIt()
    {
        InsectWings cpu = Hatched(WingSkinning.Cpu, InAuthoredOrder), gpu = Hatched(WingSkinning.Gpu);
        yield return Frames(5);

        for (int frame = 0; frame < 20; frame++)
        {
            yield return null;
            for (int wing = 0; wing < 2; wing++)
            {
                (float3[] places, float3[] normals) = GpuSkinReader.Deformed(gpu.Wings[wing].Renderer);
                Vector3[] wanted = Shown(cpu, wing).vertices, upright = Shown(cpu, wing).normals;
                for (int v = 0; v < wanted.Length; v++)
                {
                    Assert.That(math.distance(places[v], wanted[v]), Is.InRange(0f, 4e-6f));
                    Assert.That(math.distance(normals[v], math.normalize(upright[v])), Is.InRange(0f, 0.01f), "of signed bytes");
                }

                Bounds box = gpu.BoundsOf(wing);
                Assert.That(wanted.All(box.Contains), Is.True);
            }
        }

        Assert.That(gpu.SkinningObstacle, Is.Empty);
    }

    [UnityTest]
    public IEnumerator BeforeItsFirstStep_AWingIsWhereTheProcessorPutsIt_AlsoInThePlaceOfAnotherThatWent([Values] bool motion)
    {
        InsectWings gone = Hatched(WingSkinning.Gpu, made => made.Quality.motionVectors = motion);
        yield return Frames(10);
        int start = GpuSkinReader.Start(gone.Wings[0].Renderer);
        InsectWings other = Hatched(WingSkinning.Gpu);
        yield return Frames(2);
        gone.enabled = false;
        yield return null;
        InsectWings insect = Unmoved(WingSkinning.Gpu, motion), cpu = Unmoved(WingSkinning.Cpu, motion);
        Time.timeScale = 0f;
        yield return Frames(3);
        Renderer renderer = insect.Wings[0].Renderer;
        Assert.That(insect.Wings.Select(wing => GpuSkinReader.Start(wing.Renderer)), Does.Contain(start), "the place is taken again");
        Vector3[] rest = Shown(cpu, 0).vertices;
        (float3[] places, _) = GpuSkinReader.Deformed(renderer);
        float3[] past = GpuSkinReader.Past(renderer);
        for (int v = 0; v < rest.Length; v++)
        {
            Assert.That(math.distance(places[v], rest[v]), Is.InRange(0f, 4e-6f));
            Assert.That(math.distance(past[v], rest[v]), Is.InRange(0f, 4e-6f));
        }

        Assert.That(other.State, Is.EqualTo(InsectState.Ready));
    }

    [UnityTest]
    public IEnumerator InsectsOfOneMesh_ShareMeshAndMaterial_AndHaveJointsOfTheirOwn()
    {
        InsectWings[] insects = [.. Enumerable.Range(0, 40).Select(_ => Hatched(WingSkinning.Automatic))];
        yield return Frames(3);

        Renderer[] right = Array.ConvertAll(insects, insect => (Renderer)insect.Wings[0].Renderer);
        Assert.That(right.Select(renderer => renderer.sharedMaterial).Distinct().Count(), Is.EqualTo(1));
        Assert.That(insects.Select(insect => Shown(insect, 0)).Distinct().Count(), Is.EqualTo(1));
        Assert.That(insects.SelectMany(insect => insect.Wings).Select(wing => GpuSkinReader.Start(wing.Renderer)).Distinct().Count(),
            Is.EqualTo(80));
        Material copy = right[0].sharedMaterial;
        Assert.That(copy, Is.Not.SameAs(Membrane));
        Assert.That(copy.enableInstancing && copy.IsKeywordEnabled("_SKINNED"));
        Assert.That(Membrane.enableInstancing || Membrane.IsKeywordEnabled("_SKINNED"), Is.False, "the asset stays as it is");
        Assert.That(WingSystem.Loop.Skins.Materials.Count, Is.EqualTo(1));
    }

    [UnityTest]
    public IEnumerator FarAway_TheMeshStaysThatOfTheNearOnes()
    {
        InsectWings near = Hatched(WingSkinning.Gpu), far = Hatched(WingSkinning.Gpu);
        WingSystem.DetailCameras.Add(Keep(new GameObject("camera")).AddComponent<Camera>());
        near.transform.position = 2f * Vector3.forward;
        far.transform.position = 25f * Vector3.forward;
        yield return Frames(5);

        Assert.That(near.Detail, Is.EqualTo(WingDetail.Full));
        Assert.That(far.Detail, Is.EqualTo(WingDetail.CoarsePatches));
        Assert.That(Shown(far, 0), Is.SameAs(Shown(near, 0)));
        Assert.That(Shown(far, 0).triangles, Has.Length.EqualTo(WingMesh.triangles.Length));
    }

    [UnityTest]
    public IEnumerator WhatWasChanged_ComesBack()
    {
        InsectWings insect = Hatched(WingSkinning.Gpu);
        var block = new MaterialPropertyBlock();
        block.SetFloat("_Own", 3f);
        Renderer tinted = insect.Wings[1].Renderer;
        tinted.SetPropertyBlock(block);
        yield return Frames(3);
        tinted.GetPropertyBlock(block);
        Assert.That(block.GetFloat("_Own"), Is.EqualTo(3f), "properties of a script stay");

        insect.enabled = false;
        Assert.That(Shown(insect, 0), Is.SameAs(WingMesh));
        Assert.That(insect.Wings.Select(wing => wing.Renderer.sharedMaterial), Is.All.SameAs(Membrane));
        Assert.That(insect.Wings[0].Renderer.HasPropertyBlock(), Is.False);
        tinted.GetPropertyBlock(block);
        Assert.That(block.GetFloat("_Own"), Is.EqualTo(3f));
    }

    [UnityTest]
    public IEnumerator PropertiesThatAScriptSets_DoNotTakeTheJointsAway_AndTintsStay()
    {
        InsectWings insect = Hatched(WingSkinning.Gpu), other = Hatched(WingSkinning.Gpu);
        yield return Frames(3);
        Renderer renderer = other.Wings[1].Renderer;
        int start = GpuSkinReader.Start(renderer);
        Assert.That(start, Is.GreaterThan(0));
        var block = new MaterialPropertyBlock();
        renderer.GetPropertyBlock(block);
        Assert.That(block.GetColor("_SkinTint"), Is.EqualTo(Color.white));
        var own = new MaterialPropertyBlock();
        own.SetFloat("_Own", 3f);
        renderer.SetPropertyBlock(own);
        yield return null;

        Assert.That(GpuSkinReader.Start(renderer), Is.EqualTo(start));
        own.SetColor("_SkinTint", Color.red);
        renderer.SetPropertyBlock(own);
        yield return null;
        renderer.GetPropertyBlock(block);
        Assert.That(GpuSkinReader.Start(renderer), Is.EqualTo(start));
        Assert.That(block.GetColor("_SkinTint"), Is.EqualTo(Color.red));
        Assert.That(block.GetFloat("_Own"), Is.EqualTo(3f));
        Assert.That(insect.State, Is.EqualTo(InsectState.Ready));
    }

    [UnityTest]
    public IEnumerator PropertiesOfOneMaterial_DoNotHideTheJoints()
    {
        InsectWings insect = Hatched(WingSkinning.Gpu);
        yield return null;
        insect.enabled = false;
        var block = new MaterialPropertyBlock();
        block.SetFloat("_Own", 3f);
        Renderer renderer = insect.Wings[1].Renderer;
        renderer.SetPropertyBlock(block, 0);
        insect.enabled = true;
        yield return Frames(3);

        renderer.GetPropertyBlock(block, 0);
        Assert.That(block.GetFloat("_SkinStart"), Is.EqualTo(GpuSkinReader.Start(renderer)).And.GreaterThan(0f));
        Assert.That(block.GetFloat("_Own"), Is.EqualTo(3f));
    }

    [UnityTest]
    public IEnumerator ACopy_FollowsItsMaterial()
    {
        InsectWings insect = Hatched(WingSkinning.Gpu);
        yield return Frames(3);
        Material copy = insect.Wings[0].Renderer.sharedMaterial;

        Membrane.SetColor("_Color", Color.red);
        Membrane.EnableKeyword("_OWN");
        yield return null;

        Assert.That(insect.Wings[0].Renderer.sharedMaterial, Is.SameAs(copy));
        Assert.That(copy.GetColor("_Color"), Is.EqualTo(Color.red));
        Assert.That(copy.IsKeywordEnabled("_OWN") && copy.IsKeywordEnabled("_SKINNED") && copy.enableInstancing);
        Assert.That(copy.GetTexture("_SkinMap"), Is.SameAs(WingSystem.Loop.Skins.Table.Texture));
    }

    [UnityTest]
    public IEnumerator AMaterialThatAScriptGives_IsTakenUp_AndStays()
    {
        InsectWings insect = Hatched(WingSkinning.Gpu);
        yield return Frames(3);
        float beats = Beats(insect);
        Material other = Keep(new Material(Membrane) { name = "other" });
        insect.Wings[0].Renderer.sharedMaterial = other;
        yield return Frames(2);

        Assert.That(insect.Wings[0].Renderer.sharedMaterial.name, Is.EqualTo("other"));
        Assert.That(insect.Wings[0].Renderer.sharedMaterial.IsKeywordEnabled("_SKINNED"));
        Assert.That(Beats(insect), Is.GreaterThan(beats), "the beat goes on");
        insect.enabled = false;
        Assert.That(insect.Wings[0].Renderer.sharedMaterial, Is.SameAs(other));
    }

    [UnityTest]
    public IEnumerator AnInstanceThatAScriptMadeOfACopy_DrawsTheAuthoredMesh_AfterTheEnd()
    {
        InsectWings insect = Hatched(WingSkinning.Gpu);
        yield return Frames(3);
        Material own = Keep(insect.Wings[0].Renderer.material);
        own.SetColor("_Color", Color.blue);
        yield return Frames(2);
        insect.enabled = false;

        Assert.That(insect.Wings[0].Renderer.sharedMaterial.GetColor("_Color"), Is.EqualTo(Color.blue));
        Assert.That(insect.Wings[0].Renderer.sharedMaterial.IsKeywordEnabled("_SKINNED"), Is.False);
    }

    [UnityTest]
    public IEnumerator ACloneOfALivingInsect_HasTheAuthoredMaterials_AndJointsOfItsOwn()
    {
        InsectWings insect = Hatched(WingSkinning.Gpu);
        yield return Frames(3);
        InsectWings clone = Keep(UnityEngine.Object.Instantiate(insect.gameObject)).GetComponent<InsectWings>();
        clone.Quality.skinning = WingSkinning.Cpu;
        yield return Frames(3);

        Assert.That(clone.Wings[0].Renderer.sharedMaterial, Is.SameAs(Membrane));
        clone.Quality.skinning = WingSkinning.Gpu;
        yield return Frames(3);
        Assert.That(clone.Wings[0].Renderer.sharedMaterial, Is.SameAs(insect.Wings[0].Renderer.sharedMaterial));
        Assert.That(GpuSkinReader.Start(clone.Wings[0].Renderer), Is.Not.EqualTo(GpuSkinReader.Start(insect.Wings[0].Renderer)));
    }

    [UnityTest]
    public IEnumerator WhereItCannotBe_TheProcessorDeforms_AndOneLineSaysWhy(
        [Values("shader", "none", "lacks", "collider", "device", "full")] string obstacle, [Values] bool automatic)
    {
        PlainDevice.IsInUse = obstacle == "device";
        PlainDevice.LargestTexture = obstacle == "full" ? 0 : 16384;
        if (!automatic)
            LogAssert.Expect(LogType.Warning, new Regex("'insect': the processor deforms its wings, since .+\\."));
        InsectWings insect = Hatched(automatic ? WingSkinning.Automatic : WingSkinning.Gpu, made =>
        {
            foreach (Wing wing in made.Wings)
            {
                if (obstacle == "shader")
                    wing.Renderer.sharedMaterial = Keep(new Material(Shader.Find("Standard")));
                else if (obstacle == "none")
                    wing.Renderer.sharedMaterials = [];
                else if (obstacle == "lacks")
                    wing.Renderer.sharedMaterials = [Membrane, null];
                else if (obstacle == "collider")
                    wing.Renderer.gameObject.AddComponent<MeshCollider>();
            }
        });
        Material[] materials = insect.Wings[0].Renderer.sharedMaterials;
        yield return Frames(5);

        Assert.That(insect.State, Is.EqualTo(InsectState.Ready));
        Assert.That(insect.SkinningObstacle, Does.Contain(obstacle switch
        {
            "shader" => "shader 'Standard' of 'wing Right'",
            "none" => "'wing Right' has no material",
            "lacks" => "'wing Right' lacks a material",
            "collider" => "MeshCollider on 'wing Right'",
            "device" => "device reads no textures of 32-bit floats",
            _ => "texture of joints is full",
        }));
        Assert.That(insect.Wings[0].Renderer.sharedMaterials, Is.EqualTo(materials));
        Vector3[] before = Shown(insect, 0).vertices;
        yield return null;
        Assert.That(Shown(insect, 0).vertices, Is.Not.EqualTo(before), "the vertices move");
    }

    [UnityTest]
    public IEnumerator ThePast_IsWhatTheLastPictureShowed_OrThisOneAfterAReset()
    {
        // Longer than a step: a frame without one would show the wings after a reset as they were in it.
        Time.captureDeltaTime = 1.25f * Time.fixedDeltaTime;
        InsectWings insect = Hatched(WingSkinning.Gpu, made => made.Quality.motionVectors = true);
        yield return Frames(5);
        Renderer renderer = insect.Wings[0].Renderer;
        for (int frame = 0; frame < 10; frame++)
        {
            float3[] shown = GpuSkinReader.Deformed(renderer).Places;
            bool isReset = frame == 6;
            if (isReset)
                insect.ResetState();
            yield return null;
            float3[] past = GpuSkinReader.Past(renderer), now = GpuSkinReader.Deformed(renderer).Places;
            Assert.That(past, Is.EqualTo(isReset ? now : shown));
            Assert.That(now, Is.Not.EqualTo(shown), $"frame {frame}");
        }

        Time.timeScale = 0f;
        yield return Frames(3);
        Assert.That(GpuSkinReader.Past(renderer), Is.EqualTo(GpuSkinReader.Deformed(renderer).Places), "nothing moves");
    }

    [UnityTest]
    public IEnumerator ThePast_CostsMemory_OnlyWhileAnInsectWantsIt()
    {
        InsectWings still = Hatched(WingSkinning.Gpu);
        yield return Frames(3);
        SkinTable table = WingSystem.Loop.Skins.Table;
        int height = table.Texture.height, joints = table.Joints;
        Assert.That(joints, Is.EqualTo(2 * still.Live.wings[0].rig.JointCount));
        Assert.That(still.Wings[0].Renderer.sharedMaterial.GetFloat("_SkinLast"), Is.Zero);

        InsectWings moving = Hatched(WingSkinning.Gpu, made => made.Quality.motionVectors = true);
        yield return Frames(3);
        Assert.That(table.Texture.height, Is.EqualTo(2 * height));
        Assert.That(still.Wings[0].Renderer.sharedMaterial.GetFloat("_SkinLast"), Is.EqualTo(height * SkinTable.Width));
        Assert.That(still.Wings[0].Renderer.sharedMaterial.GetTexture("_SkinMap"), Is.SameAs(table.Texture));

        moving.enabled = false;
        yield return Frames(2);
        Assert.That(table.Texture.height, Is.EqualTo(height));
        Assert.That(table.Joints, Is.EqualTo(joints), "its block is free");
        (float3[] places, _) = GpuSkinReader.Deformed(still.Wings[0].Renderer);
        Assert.That(places.Max(place => math.length(place)), Is.InRange(0.5f, 1.5f), "the present is kept");
    }

    private InsectWings Unmoved(WingSkinning skinning, bool motion) => Hatched(skinning, made =>
    {
        made.UpdateMode = WingUpdateMode.Manual;
        made.Quality.motionVectors = motion;
        InAuthoredOrder(made);
    });

    // Where there are smaller meshes for the distance, their vertices come first.
    private static void InAuthoredOrder(InsectWings made) => made.Quality.levelOfDetail = false;
}
