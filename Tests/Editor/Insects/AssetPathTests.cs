using NUnit.Framework;

namespace Alate.Editor.Tests
{
    public sealed class AssetPathTests
    {
        [TestCase("Assets/Monarch.asset")]
        [TestCase("Assets/Insects/My wings.asset")]
        public void PlaceInTheProject_IsGood(string path)
        {
            Assert.That(AssetPath.FindProblem(path), Is.Null);
        }

        [TestCase("Packages/com.alate.insect-wings/Monarch.asset", "read-only")]
        [TestCase("Library/PackageCache/x.asset", "Assets")]
        [TestCase("/tmp/Monarch.asset", "Assets")]
        [TestCase("Assets/Monarch.txt", ".asset")]
        public void PlaceElsewhere_IsRefusedWithItsName(string path, string reason)
        {
            Assert.That(AssetPath.FindProblem(path), Does.Contain(path).And.Contain(reason));
        }

        [TestCase("Blue: big / small?", "Blue_ big _ small_")]
        [TestCase(" wing. ", "wing")]
        [TestCase("...", "Asset")]
        public void FileName_HasNoForbiddenCharacters(string name, string expected)
        {
            Assert.That(AssetPath.FileName(name), Is.EqualTo(expected));
        }

        [Test]
        public void PathBeside_BeginsLikeTheOther()
        {
            Assert.That(AssetPath.Beside("Assets/a.b/Monarch.asset", "Fore/Left"), Is.EqualTo("Assets/a.b/Monarch Fore_Left.asset"));
        }
    }
}
