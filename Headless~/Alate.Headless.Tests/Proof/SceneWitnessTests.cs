using System.Collections;
using System.IO;
using System.Linq;
using System.Reflection;
using Alate.Showcase;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play.Proof;

/// <summary>The witness of a scene that plays: its pictures, its account, and what it counts.</summary>
public sealed class SceneWitnessTests : PlayFixture
{
    private string m_Folder;

    [SetUp]
    public void MakeFolder() => m_Folder = Directory.CreateTempSubdirectory("alate-witness-").FullName;

    [TearDown]
    public void DeleteFolder() => Directory.Delete(m_Folder, true);

    [UnityTest]
    public IEnumerator PicturesAreTaken_WhenTheirTimesHaveCome_AndTheLastEndsIt()
    {
        Eye();
        Witness(0.1f, 0.2f);
        yield return Frames(3);
        Assert.That(SceneWitness.IsDone, Is.False);
        Assert.That(Directory.GetFiles(m_Folder), Is.Empty);
        yield return Frames(30);

        Assert.That(SceneWitness.IsDone, Is.True);
        Assert.That(Directory.GetFiles(m_Folder).Select(Path.GetFileName),
            Is.EquivalentTo(new[] { "Meadow 00.1 s.png", "Meadow 00.2 s.png", "Meadow.account.json" }));
        var account = SceneAccount.Read(m_Folder, "Meadow");
        Assert.That((account.pictures, account.errors), Is.EqualTo((2, 0)));
        Assert.That(account.blank, Is.EqualTo(2), "nothing draws here: each picture is of one colour");
        Assert.That(account.frames * account.milliseconds, Is.EqualTo(200f).Within(40f), "from the start to the last picture");
    }

    [UnityTest]
    public IEnumerator ErrorsAreCounted_AndTheFirstIsKept_WarningsAreNot()
    {
        Eye();
        Witness(0.1f);
        yield return Frames(2);
        LogAssert.Expect(LogType.Error, "first");
        LogAssert.Expect(LogType.Error, "second");
        Debug.LogWarning("mind");
        Debug.LogError("first");
        Debug.LogError("second");
        yield return Frames(20);
        var account = SceneAccount.Read(m_Folder, "Meadow");
        Assert.That((account.errors, account.firstError), Is.EqualTo((2, "first")));
    }

    [UnityTest]
    public IEnumerator ASceneWithoutACamera_GivesABlankPicture_AndAnAccount()
    {
        Witness(0.05f);
        yield return Frames(20);
        var account = SceneAccount.Read(m_Folder, "Meadow");
        Assert.That((account.pictures, account.blank), Is.EqualTo((1, 1)));
    }

    [UnityTest]
    public IEnumerator AnAccount_HasMillisecondsOfAFrame_AndPicturesAreAFullHdHalf()
    {
        Eye();
        Witness(0.1f);
        yield return Frames(20);
        var account = SceneAccount.Read(m_Folder, "Meadow");
        Assert.That(account.frames, Is.InRange(6, 7));
        Assert.That(account.milliseconds, Is.EqualTo(1000f * Time.unscaledDeltaTime).Within(0.5f));
        byte[] header = File.ReadAllBytes(Path.Combine(m_Folder, "Meadow 00.1 s.png"));
        Assert.That((header[18] << 8) + header[19], Is.EqualTo(1920 / 2), "width in the first chunk");
        Assert.That((header[22] << 8) + header[23], Is.EqualTo(1080 / 2));
    }

    [UnityTest]
    public IEnumerator APicture_LeavesTheCameraAndTheDeviceAsTheyWere_OfWhateverCameraThereIs()
    {
        GameObject eye = Keep(new GameObject("eye", typeof(Camera)));
        RenderTexture own = RenderTexture.GetTemporary(8, 8, 0), active = RenderTexture.GetTemporary(4, 4, 0);
        eye.GetComponent<Camera>().targetTexture = own;
        RenderTexture.active = active;
        Witness(0.05f);
        yield return Frames(10);
        (RenderTexture target, RenderTexture left) = (eye.GetComponent<Camera>().targetTexture, RenderTexture.active);
        eye.GetComponent<Camera>().targetTexture = null;
        RenderTexture.active = null;
        RenderTexture.ReleaseTemporary(own);
        RenderTexture.ReleaseTemporary(active);
        Assert.That(target, Is.SameAs(own));
        Assert.That(left, Is.SameAs(active));
        Assert.That(File.Exists(Path.Combine(m_Folder, "Meadow 00.1 s.png")) || File.Exists(Path.Combine(m_Folder, "Meadow 00 s.png")),
            Is.True, "taken by a camera that is not the main one");
    }

    // The stand-in reads nothing beyond what was drawn, and tells so; a picture is an object that must be ended.
    [UnityTest]
    public IEnumerator APicture_IsReadWithinWhatWasDrawn_AndEndsWithItsFile()
    {
        int textures = Resources.FindObjectsOfTypeAll<Texture>().Length;
        Eye();
        Witness(0.05f, 0.1f);
        yield return Frames(20);
        Assert.That(SceneWitness.IsDone, Is.True);
        Assert.That(SceneAccount.Read(m_Folder, "Meadow").errors, Is.Zero);
        LogAssert.NoUnexpectedReceived();
        Assert.That(Resources.FindObjectsOfTypeAll<Texture>(), Has.Length.EqualTo(textures));
    }

    [UnityTest]
    public IEnumerator AfterItsEnd_NothingIsTakenOrCounted()
    {
        Eye();
        SceneWitness witness = Witness(0.05f);
        yield return Frames(10);
        var account = (SceneAccount)typeof(SceneWitness).GetField("m_Account", BindingFlags.NonPublic | BindingFlags.Instance)
            .GetValue(witness);
        (int frames, int pictures) = (account.frames, account.pictures);
        string[] files = Directory.GetFiles(m_Folder);
        yield return Frames(10);
        Assert.That((account.frames, account.pictures), Is.EqualTo((frames, pictures)));
        Assert.That(Directory.GetFiles(m_Folder), Is.EquivalentTo(files));
    }

    // Without a folder its files go where a game may write.
    [UnityTest]
    public IEnumerator WithoutAFolder_ItWritesWhereAGameMay()
    {
        Directory.CreateDirectory(Application.persistentDataPath);
        Eye();
        Witness(0.05f).Folder = "";
        yield return Frames(10);
        var account = SceneAccount.Read(Application.persistentDataPath, "Meadow");
        Directory.Delete(Application.persistentDataPath, true);
        Assert.That(account?.pictures, Is.EqualTo(1));
        Assert.That(Directory.GetFiles(m_Folder), Is.Empty);
    }

    [UnityTest]
    public IEnumerator ASecondWitness_IsNotDoneFromTheStart_AndOneThatIsOffCountsNoErrors()
    {
        Eye();
        Witness(0.05f);
        yield return Frames(10);
        Assert.That(SceneWitness.IsDone, Is.True);
        SceneWitness second = Witness(100f);
        Assert.That(SceneWitness.IsDone, Is.False);
        yield return Frames(2);
        second.enabled = false;
        LogAssert.Expect(LogType.Error, "unheard");
        Debug.LogError("unheard");
        var account = (SceneAccount)typeof(SceneWitness).GetField("m_Account", BindingFlags.NonPublic | BindingFlags.Instance)
            .GetValue(second);
        Assert.That((account.errors, account.pictures), Is.EqualTo((0, 0)));
        Assert.That(account.frames, Is.GreaterThan(0));
    }

    [Test]
    public void WithoutAnAccount_ThereIsNone() => Assert.That(SceneAccount.Read(m_Folder, "Meadow"), Is.Null);

    private void Eye() => Keep(new GameObject("eye", typeof(Camera))).tag = "MainCamera";

    private SceneWitness Witness(params float[] times)
    {
        SceneWitness witness = Keep(new GameObject("witness")).AddComponent<SceneWitness>();
        witness.Folder = m_Folder;
        witness.SceneName = "Meadow";
        witness.Times = times;
        return witness;
    }
}
