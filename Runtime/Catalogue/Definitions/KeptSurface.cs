namespace Alate.Catalogue
{
    /// <summary>The surface of an outline that was meshed last.</summary>
    internal sealed class KeptSurface
    {
        private MadeSurface m_Made;

        /// <summary>Returns the surface of a wing, meshed where the one that is kept is of other numbers.</summary>
        /// <param name="wing">A wing with an outline.</param>
        /// <param name="scale">Mesh units of one wing length.</param>
        public MadeSurface Get(WingDefinition wing, float scale)
        {
            MadeSurface made = m_Made;
            if (made == null || !made.Is(wing, scale))
                m_Made = made = new MadeSurface(wing, scale);
            return made;
        }
    }
}
