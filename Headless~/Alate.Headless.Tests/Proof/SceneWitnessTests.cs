using System.Collections;
using System.IO;
using System.Linq;
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

    [Test]
    public void WithoutAnAccount_ThereIsNone() => Assert.That(SceneAccount.Read(m_Folder, "Meadow"), Is.Null);

    private void Eye() => Keep(new GameObject("eye", typeof(Camera))).tag = "MainCamera";

    private void Witness(params float[] times)
    {
        SceneWitness witness = Keep(new GameObject("witness")).AddComponent<SceneWitness>();
        witness.Folder = m_Folder;
        witness.SceneName = "Meadow";
        witness.Times = times;
    }
}
