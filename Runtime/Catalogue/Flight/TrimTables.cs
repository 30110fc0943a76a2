namespace Alate.Catalogue
{
    /// <summary>Trim tables of the insects as text; written by the command line: trim SPECIES --bake.</summary>
    internal static class TrimTables
    {
        /// <summary>Table of an insect, its own or that of the catalogue; null where there is none.</summary>
        public static string Of(InsectDefinition insect) => insect.Trims ?? Of(insect.Name);

        /// <summary>Table of an insect of the catalogue; null where there is none.</summary>
        public static string Of(string name)
        {
            switch (name)
            {
                case "monarch": return MonarchTrims.Text;
                case "swallowtail": return SwallowtailTrims.Text;
                case "firefly": return FireflyTrims.Text;
                case "fishfly": return FishflyTrims.Text;
                case "painted-lichen-moth": return PaintedLichenMothTrims.Text;
                case "snailfish": return SnailfishTrims.Text;
                case "dragonfly": return DragonflyTrims.Text;
                default: return null;
            }
        }
    }
}
