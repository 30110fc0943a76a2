using System.Linq;
using System.Reflection;
using Alate.Catalogue;
using Alate.Editor;
using Alate.Flight;
using NUnit.Framework;
using StandIns;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Alate.Tests.Editor;

/// <summary>The menu items themselves, and what needs an open prefab.</summary>
public sealed class InsectMenuTests
{
    [TearDown]
    public void TakeAllAway()
    {
        Selection.activeObject = null;
        AssetDatabase.DeleteAsset("Assets/Alate");
        Undo.ClearAll();
    }

    [Test]
    public void EverySpecies_HasAnItemThatPlacesIt_AndOneThatSavesIt()
    {
        string[] items = Items().Select(item => item.Path).ToArray();
        foreach (InsectDefinition species in InsectCatalogue.All)
        {
            Assert.That(items, Has.One.EqualTo("GameObject/Alate/" + species.DisplayName).IgnoreCase);
            Assert.That(items, Has.One.EqualTo("Assets/Create/Alate/Insects/" + species.DisplayName).IgnoreCase);
            // Fish swim: they wander too slowly for a pilot of butterflies. What has no variant that flies has no such item.
            if (species.Name != "snailfish" && species.Variants.Contains(InsectVariant.Flight))
                Assert.That(items, Has.One.EqualTo("GameObject/Alate/Flying/" + species.DisplayName).IgnoreCase);
        }
    }

    [Test]
    public void Item_MakesTheSpeciesOfItsName([Values("Firefly", "Snailfish")] string name)
    {
        Items().Single(item => item.Path == "GameObject/Alate/" + name).Method.Invoke(null, [new MenuCommand(null)]);
        GameObject made = Selection.activeGameObject;
        Assert.That(made.name, Is.EqualTo(name));
        Assert.That(made.GetComponent<InsectWings>().Wings, Is.Not.Empty);
        Object.DestroyImmediate(made);
    }

    [Test]
    public void FlyingItem_MakesAnInsectThatFlies()
    {
        Items().Single(item => item.Path == "GameObject/Alate/Flying/Firefly").Method.Invoke(null, [new MenuCommand(null)]);
        GameObject made = Selection.activeGameObject;
        Assert.That(made.name, Is.EqualTo("Flying Firefly"));
        Assert.That(made.GetComponent<InsectFlight>().Trims != null, Is.True);
        Object.DestroyImmediate(made);
    }

    [Test]
    public void SavingItem_SelectsANewPrefab_AndNeverWritesOverOne()
    {
        MethodInfo save = Items().Single(item => item.Path == "Assets/Create/Alate/Insects/Firefly").Method;
        Selection.activeObject = null;
        save.Invoke(null, null);
        string first = AssetDatabase.GetAssetPath(Selection.activeObject);
        Selection.activeObject = null;
        save.Invoke(null, null);
        string second = AssetDatabase.GetAssetPath(Selection.activeObject);

        Assert.That(first, Is.EqualTo("Assets/Firefly/Firefly.prefab"));
        Assert.That(second, Is.EqualTo("Assets/Firefly 1/Firefly.prefab"));
        AssetDatabase.DeleteAsset("Assets/Firefly");
        AssetDatabase.DeleteAsset("Assets/Firefly 1");
    }

    [Test]
    public void IntoItsOwnOpenPrefab_AnInsectIsPutAsAPlainCopy()
    {
        var placing = new InsectPlacing();
        Object.DestroyImmediate(placing.Place("firefly", null));
        GameObject inside, elsewhere;
        using (new OpenPrefab("Assets/Alate/Firefly/Firefly.prefab"))
            inside = placing.Place("firefly", null);
        using (new OpenPrefab("Assets/Meadow.prefab"))
            elsewhere = placing.Place("firefly", null);

        Assert.That(PrefabUtility.IsPartOfPrefabInstance(inside), Is.False);
        Assert.That(inside.name, Is.EqualTo("Firefly"));
        Assert.That(PrefabUtility.IsPartOfPrefabInstance(elsewhere), Is.True);
        Object.DestroyImmediate(inside);
        Object.DestroyImmediate(elsewhere);
    }

    private static (string Path, MethodInfo Method)[] Items()
    {
        return (
            from method in typeof(InsectPlacing).Assembly.GetType("Alate.Editor.InsectMenu", true)
                .GetMethods(BindingFlags.Static | BindingFlags.NonPublic)
            from item in method.GetCustomAttributesData()
            where item.AttributeType == typeof(MenuItem)
            select ((string)item.ConstructorArguments[0].Value, method)).ToArray();
    }
}
