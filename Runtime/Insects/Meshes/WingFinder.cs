using System.Collections.Generic;
using UnityEngine;
namespace Alate
{
    internal static class WingFinder { public static List<Wing> Find(Transform root) => new List<Wing>(); }
}
