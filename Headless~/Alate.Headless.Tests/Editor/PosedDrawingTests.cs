using System.Linq;
using Alate.Editor;
using Alate.Editor.Tests;
using NUnit.Framework;
using StandIns;
using Unity.StandIns;
using UnityEditor;
using UnityEngine;
using UnityEngine.Rendering;

namespace Alate.Tests.Editor;

/// <summary>Posed meshes as they are drawn in the place of the authored ones, what they hold, and when play ends them.</summary>
public sealed class PosedDrawingTests : InsectFixture
{
    [SetUp]
    public void Begin() => BeatScrubbing.Clear();

    [TearDown]
    public void End()
    {
        DrawnInstances.Calls = null;
        BeatScrubbing.Clear();
    }

    [Test]
    public void APosedMesh_IsDrawnAsItsRendererWould_EachSubmeshWithItsMaterial()
    {
        InsectWings insect = Insect();
        insect.Preview.shows = true;
        insect.transform.SetPositionAndRotation(new Vector3(1f, 2f, 3f), Quaternion.Euler(0f, 30f, 0f));
        MeshRenderer renderer = insect.Wings[0].Renderer;
        Mesh mesh = MeshOf(insect.Wings[0]);
        mesh.subMeshCount = 2;
        var shader = Shader.Find("Standard");
        Material one = Keep(new Material(shader)), two = Keep(new Material(shader)), three = Keep(new Material(shader));
        renderer.gameObject.layer = 5;
        (renderer.renderingLayerMask, renderer.shadowCastingMode, renderer.receiveShadows) = (6u, ShadowCastingMode.TwoSided, true);
        using var posed = new PosedInsect(insect);
        posed.Refresh();
        PosedMesh drawn = posed.Meshes[0];
        Camera camera = Keep(new GameObject("eye")).AddComponent<Camera>();

        DrawnBatch[] Draw(params Material[] materials)
        {
            renderer.sharedMaterials = materials;
            DrawnInstances.Calls = [];
            drawn.Draw(camera);
            return [.. DrawnInstances.Calls];
        }

        DrawnBatch[] both = Draw(one, two, three);
        Assert.That(both.Select(batch => (batch.Material, batch.Submesh)),
            Is.EqualTo(new[] { (one, 0), (two, 1) }), "as many as submeshes");
        foreach (DrawnBatch batch in both)
        {
            Assert.That((batch.Mesh, batch.Camera, batch.Matrices.Single()), Is.EqualTo((drawn.Mesh, camera, renderer.localToWorldMatrix)));
            RenderParams how = batch.Parameters;
            Assert.That((how.layer, how.renderingLayerMask, how.shadowCastingMode, how.receiveShadows),
                Is.EqualTo((5, 6u, ShadowCastingMode.TwoSided, true)));
        }

        Assert.That(Draw(null, two).Select(batch => (batch.Material, batch.Submesh)), Is.EqualTo(new[] { (two, 1) }));
        Assert.That(Draw(one), Has.Length.EqualTo(1));
        Assert.That(Draw(), Is.Empty);
        renderer.enabled = false;
        Assert.That(Draw(one), Is.Empty);
        renderer.enabled = true;
        renderer.gameObject.SetActive(false);
        Assert.That(Draw(one), Is.Empty);
        renderer.gameObject.SetActive(true);
        Assert.That(Draw(one), Has.Length.EqualTo(1));
    }

    [Test]
    public void AnInsectThatIsNotPosedAnyMore_LeavesNoMeshAndNoNativeMemory()
    {
        InsectWings insect = Insect();
        insect.Preview.shows = true;
        int meshes = Resources.FindObjectsOfTypeAll<Mesh>().Length, memory = NativeMemoryLedger.LiveCount;
        var posed = new PosedInsect(insect);
        posed.Refresh();
        Assert.That(Resources.FindObjectsOfTypeAll<Mesh>(), Has.Length.EqualTo(meshes + 2));
        insect.Preview.beat = 0.4f;
        posed.Refresh();
        insect.Quality.patches = 32;
        posed.Refresh();
        Assert.That(Resources.FindObjectsOfTypeAll<Mesh>(), Has.Length.EqualTo(meshes + 2), "a new rig takes the place of the old one");
        posed.Dispose();
        Assert.That(Resources.FindObjectsOfTypeAll<Mesh>(), Has.Length.EqualTo(meshes));
        Assert.That(NativeMemoryLedger.LiveCount, Is.EqualTo(memory));
    }

    [Test]
    public void Poses_EndWhenPlayBegins_AndComeBackWithEditMode()
    {
        InsectWings insect = Insect(), other = Insect();
        insect.Preview.shows = true;
        RunningEditor.Tell(PlayModeStateChange.EnteredEditMode);
        Assert.That(BeatScrubbing.All, Has.Count.EqualTo(1), "the other does not ask");
        BeatScrubbing.Refresh();
        Assert.That(insect.Wings[0].Renderer.forceRenderingOff, Is.True);
        foreach (PlayModeStateChange change in new[] { PlayModeStateChange.EnteredPlayMode, PlayModeStateChange.ExitingPlayMode })
        {
            RunningEditor.Tell(change);
            Assert.That(BeatScrubbing.All, Has.Count.EqualTo(1));
        }

        RunningEditor.Tell(PlayModeStateChange.ExitingEditMode);
        Assert.That(BeatScrubbing.All, Is.Empty);
        Assert.That(insect.Wings[0].Renderer.forceRenderingOff, Is.False);
        other.Preview.shows = true;
        RunningEditor.Tell(PlayModeStateChange.EnteredEditMode);
        RunningEditor.Tell(PlayModeStateChange.EnteredEditMode);
        Assert.That(BeatScrubbing.All, Has.Count.EqualTo(2), "each once");
    }

    [Test]
    public void AStatus_IsLookedAtAgain_AfterHalfASecond_OrAtOnceWhereTheInsectWasChanged()
    {
        InsectWings insect = Insect();
        Wing[] wings = [.. insect.Wings];
        var box = new StatusBox();
        try
        {
            RunningEditor.Seconds = 10.0;
            insect.Wings.Clear();
            box.Refresh([insect], false);
            Assert.That(Shown().HelpBoxes.Count(), Is.EqualTo(1), "looked at for the first time");
            insect.Wings.AddRange(wings);
            RunningEditor.Seconds = 10.49;
            box.Refresh([insect], false);
            Assert.That(Shown().HelpBoxes.Count(), Is.EqualTo(1), "not yet");
            RunningEditor.Seconds = 10.5;
            box.Refresh([insect], false);
            Assert.That(Shown().HelpBoxes, Is.Empty);
            insect.Wings.Clear();
            box.Refresh([insect], true);
            Assert.That(Shown().HelpBoxes.Count(), Is.EqualTo(1), "changed");
            Assert.That(Shown().Buttons, Is.EqualTo(new[] { "Find Wings" }));
        }
        finally
        {
            RunningEditor.Seconds = null;
        }

        DrawnInspector Shown() => DrawnInspector.Of(() => box.Draw());
    }

    [Test]
    public void AnAnswer_StaysUntilThereIsAnotherProblem()
    {
        InsectWings insect = Insect();
        var box = new StatusBox();
        box.Refresh([insect], true);
        box.Show(FixOutcome.Done("Done so."));
        Assert.That(Texts(), Has.Member("Done so."));
        box.Refresh([insect], true);
        Assert.That(Texts(), Has.Member("Done so."), "still well");
        insect.Wings.Clear();
        box.Refresh([insect], true);
        Assert.That(Texts(), Has.No.Member("Done so."));
        box.Show(FixOutcome.Refused("Not so."));
        box.Refresh([insect], true);
        Assert.That(Texts(), Has.Member("Not so."), "the same problem");

        string[] Texts() => [.. DrawnInspector.Of(() => box.Draw()).Controls.Select(control => control.Text)];
    }
}
