namespace Alate.Editor
{
    /// <summary>Names of the saved fields of <see cref="Wing"/>.</summary>
    internal static class WingFields
    {
        public const string Renderer = "m_Renderer", Part = "m_Part", Submesh = "m_Submesh", Point = "m_Point", Side = "m_Side",
            Pair = "m_Pair";

        /// <summary>Fields below the part, from top to bottom.</summary>
        public static readonly string[] Rest = { "m_Skeleton", Side, Pair, "m_Preset", "m_AmplitudeScale", "m_PhaseLead" };
    }
}
