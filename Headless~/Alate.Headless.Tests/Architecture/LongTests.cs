using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using Alate.Tests.Play;
using NUnit.Framework;

namespace Alate.Tests.Architecture
{
    /// <summary>Tests that take minutes: a plain run leaves them out, <c>.ci/long</c> finds them by their category.</summary>
    public sealed class LongTests
    {
        [Test]
        public void EachTestOfTheCategory_IsExplicit_AndNoOtherOneIs()
        {
            Assembly[] tests = [typeof(LongTests).Assembly, typeof(PlayFixture).Assembly];
            IEnumerable<MemberInfo> places = tests.SelectMany(assembly => assembly.GetTypes())
                .SelectMany(type => type.GetMethods(BindingFlags.Public | BindingFlags.Instance | BindingFlags.DeclaredOnly)
                    .Append<MemberInfo>(type));

            Assert.That(places.Where(place => IsLong(place) != IsExplicit(place)).Select(Name), Is.Empty);
            Assert.That(places.SelectMany(place => place.GetCustomAttributes<TestCaseAttribute>(), (place, test) => (place, test))
                .Where(one => one.test.Category == "Long" != one.test.Explicit).Select(one => Name(one.place)), Is.Empty);
        }

        private static bool IsLong(MemberInfo place) =>
            place.GetCustomAttributes<CategoryAttribute>(inherit: false).Any(category => category.Name == "Long");

        private static bool IsExplicit(MemberInfo place) => place.IsDefined(typeof(ExplicitAttribute), inherit: false);

        private static string Name(MemberInfo place) => $"{place.DeclaringType?.Name}.{place.Name}";
    }
}
