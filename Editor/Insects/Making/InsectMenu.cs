using Alate.Catalogue;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>
    /// The menus that make insects: <i>GameObject > Alate</i> places one that beats on the spot, <i>GameObject > Alate > Flying</i> one
    /// that flies about, <i>Assets > Create > Alate</i> saves the prefabs of both into the folder that is selected.
    /// </summary>
    internal static class InsectMenu
    {
        private const string k_Place = "GameObject/Alate/", k_Flying = k_Place + "Flying/", k_Save = "Assets/Create/Alate/Insects/";
        private const int k_PlacePriority = 10, k_SavePriority = 312;

        [MenuItem(k_Place + "Monarch", false, k_PlacePriority)]
        private static void PlaceMonarch(MenuCommand command) => Place("monarch", command);

        [MenuItem(k_Place + "Swallowtail", false, k_PlacePriority)]
        private static void PlaceSwallowtail(MenuCommand command) => Place("swallowtail", command);

        [MenuItem(k_Place + "Firefly", false, k_PlacePriority)]
        private static void PlaceFirefly(MenuCommand command) => Place("firefly", command);

        [MenuItem(k_Place + "Fishfly", false, k_PlacePriority)]
        private static void PlaceFishfly(MenuCommand command) => Place("fishfly", command);

        [MenuItem(k_Place + "Painted Lichen Moth", false, k_PlacePriority)]
        private static void PlacePaintedLichenMoth(MenuCommand command) => Place("painted-lichen-moth", command);

        [MenuItem(k_Place + "Snailfish", false, k_PlacePriority)]
        private static void PlaceSnailfish(MenuCommand command) => Place("snailfish", command);

        [MenuItem(k_Place + "Dragonfly", false, k_PlacePriority)]
        private static void PlaceDragonfly(MenuCommand command) => Place("dragonfly", command);

        [MenuItem(k_Flying + "Monarch", false, k_PlacePriority)]
        private static void PlaceFlyingMonarch(MenuCommand command) => Place("monarch", command, true);

        [MenuItem(k_Flying + "Swallowtail", false, k_PlacePriority)]
        private static void PlaceFlyingSwallowtail(MenuCommand command) => Place("swallowtail", command, true);

        [MenuItem(k_Flying + "Firefly", false, k_PlacePriority)]
        private static void PlaceFlyingFirefly(MenuCommand command) => Place("firefly", command, true);

        [MenuItem(k_Flying + "Fishfly", false, k_PlacePriority)]
        private static void PlaceFlyingFishfly(MenuCommand command) => Place("fishfly", command, true);

        [MenuItem(k_Flying + "Painted Lichen Moth", false, k_PlacePriority)]
        private static void PlaceFlyingPaintedLichenMoth(MenuCommand command) => Place("painted-lichen-moth", command, true);

        [MenuItem(k_Flying + "Dragonfly", false, k_PlacePriority)]
        private static void PlaceFlyingDragonfly(MenuCommand command) => Place("dragonfly", command, true);

        [MenuItem(k_Save + "Monarch", false, k_SavePriority)]
        private static void SaveMonarch() => Save("monarch");

        [MenuItem(k_Save + "Swallowtail", false, k_SavePriority)]
        private static void SaveSwallowtail() => Save("swallowtail");

        [MenuItem(k_Save + "Firefly", false, k_SavePriority)]
        private static void SaveFirefly() => Save("firefly");

        [MenuItem(k_Save + "Fishfly", false, k_SavePriority)]
        private static void SaveFishfly() => Save("fishfly");

        [MenuItem(k_Save + "Painted Lichen Moth", false, k_SavePriority)]
        private static void SavePaintedLichenMoth() => Save("painted-lichen-moth");

        [MenuItem(k_Save + "Snailfish", false, k_SavePriority)]
        private static void SaveSnailfish() => Save("snailfish");

        [MenuItem(k_Save + "Dragonfly", false, k_SavePriority)]
        private static void SaveDragonfly() => Save("dragonfly");

        private static void Place(string species, MenuCommand command, bool flies = false)
        {
            // The menu is called once for each selected object, with it as the context.
            new InsectPlacing().Place(species, command.context as GameObject, flies);
        }

        private static void Save(string species) => Save(InsectCatalogue.Find(species));

        /// <summary>Saves the prefabs of an insect into a new folder, in the one that is selected, and selects them.</summary>
        public static void Save(InsectDefinition definition)
        {
            string folder = AssetDatabase.GenerateUniqueAssetPath($"{AssetFolder.Of(Selection.activeObject)}/{definition.DisplayName}");
            ProjectWindowUtil.ShowCreatedAsset(new InsectAssets(folder).FindOrSave(definition));
        }
    }
}
