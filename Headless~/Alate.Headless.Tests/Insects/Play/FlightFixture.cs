using Alate.Catalogue;
using Alate.Flight;

namespace Alate.Tests.Play
{
    /// <summary>Play-mode tests of insects that fly by their own wings.</summary>
    public abstract class FlightFixture : PlayFixture
    {
        /// <inheritdoc/>
        protected override bool KeepsParts => true;

        /// <summary>Insect of the catalogue that flies, computed also out of the sight of cameras.</summary>
        protected InsectFlight Hatch(string name = "monarch")
        {
            InsectDefinition species = InsectCatalogue.Find(name);
            InsectWings wings = Keep(InsectFactory.Create(species, InsectVariant.Flight).gameObject).GetComponent<InsectWings>();
            wings.Quality.culling = WingCulling.AlwaysSimulate;
            return CatalogueFlight.AddTo(wings, species);
        }
    }
}
