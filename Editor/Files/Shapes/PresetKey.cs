using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using UnityEngine;

namespace Alate.Files
{
    /// <summary>A key of a file that stands for one number or choice of a preset.</summary>
    internal sealed class PresetKey : FileKey
    {
        /// <summary>Units of presets, and those of files: the words behind a key, and how many make one of the preset's.</summary>
        private static readonly Dictionary<string, (string Suffix, string Words, decimal PerUnit)> s_Units =
            new Dictionary<string, (string, string, decimal)>
            {
                [""] = ("", "", 1m),
                ["m"] = ("Millimetres", "millimetres", 1e3m),
                ["kg"] = ("Milligrams", "milligrams", 1e6m),
                ["kg/m³"] = ("KilogramsPerCubicMetre", "kilograms per cubic metre", 1m),
                ["Hz"] = ("Hertz", "hertz", 1m),
                ["m/s"] = ("MetresPerSecond", "metres per second", 1m),
                ["°"] = ("Degrees", "degrees", 1m),
                ["beats"] = ("Beats", "beats", 1m),
                ["half beats"] = ("HalfBeats", "half beats", 1m),
                ["chain lengths"] = ("ChainLengths", "chain lengths", 1m),
            };

        /// <param name="name">With its unit in words.</param>
        /// <param name="shape">The value.</param>
        /// <param name="help">One or two sentences.</param>
        /// <param name="of">The value of a preset, as the file has it.</param>
        /// <param name="read">Reads a checked value, and returns what gives it to a preset.</param>
        public PresetKey(
            string name, FileShape shape, string help, Func<WingPreset, object> of, Func<JsonPlace, Action<WingPreset>> read)
            : base(name, shape, help)
        {
            Of = of;
            Read = read;
        }

        /// <summary>Reference to a group of a preset.</summary>
        public delegate ref T Group<T>(WingPreset preset) where T : struct;

        /// <summary>The value of a preset as the file has it: a decimal, a place in metres, a bool or a word.</summary>
        public Func<WingPreset, object> Of { get; }

        /// <summary>Reads a checked value once, and returns what gives it to any number of presets.</summary>
        public Func<JsonPlace, Action<WingPreset>> Read { get; }

        /// <summary>This key by another name.</summary>
        public PresetKey Named(string name) => new PresetKey(name, Shape, Help, Of, Read);

        /// <summary>This key with other help.</summary>
        public PresetKey With(string help) => new PresetKey(Name, Shape, help, Of, Read);

        /// <summary>Keys of all fields of a group, in its order.</summary>
        public static IEnumerable<PresetKey> All<T>(Group<T> group) where T : struct =>
            typeof(T).GetFields(BindingFlags.Public | BindingFlags.Instance).OrderBy(field => field.MetadataToken)
                .Select(field => Field(group, field.Name));

        /// <summary>Key of a field.</summary>
        /// <param name="group">The struct that has it.</param>
        /// <param name="field">Its name there.</param>
        /// <param name="name">Its name in the file without the unit; null for that of the field.</param>
        /// <param name="help">Its help; null for the inspector's.</param>
        public static PresetKey Field<T>(Group<T> group, string field, string name = null, string help = null) where T : struct
        {
            FieldInfo found = typeof(T).GetField(field);
            help ??= found.GetCustomAttribute<TooltipAttribute>()?.tooltip ?? "";
            name ??= field;
            if (found.FieldType == typeof(float))
                return Number(group, found, name, help);
            if (found.FieldType == typeof(Vector3))
                return Place(group, found, name, help);
            if (found.FieldType == typeof(bool))
            {
                return new PresetKey(name, new ChoiceShape(), help, preset => Get(group, found, preset),
                    value => Put(group, found, value.Text == "true"));
            }

            string[] words = Array.ConvertAll(Enum.GetNames(found.FieldType), Camel);
            return new PresetKey(name, new ChoiceShape(words), help, preset => Camel(Get(group, found, preset).ToString()),
                value => Put(group, found, Enum.GetValues(found.FieldType).GetValue(Array.IndexOf(words, value.Text))));
        }

        private static PresetKey Number<T>(Group<T> group, FieldInfo field, string name, string help) where T : struct
        {
            RangeAttribute range = field.GetCustomAttribute<RangeAttribute>();
            UnitAttribute unit = field.GetCustomAttribute<UnitAttribute>();
            // Angles of the rest have a range alone.
            (string suffix, string words, decimal perUnit) = s_Units[unit?.Unit ?? "°"];
            var shape = new NumberShape(
                FileNumber.ToFile(range?.min ?? unit.Min, perUnit), FileNumber.ToFile(range?.max ?? unit.Max, perUnit), words);
            return new PresetKey(
                name + suffix, shape, help, preset => FileNumber.ToFile((float)Get(group, field, preset), perUnit),
                value => Put(group, field, FileNumber.ToPreset(value.Text, perUnit)));
        }

        private static PresetKey Place<T>(Group<T> group, FieldInfo field, string name, string help) where T : struct => new PresetKey(
            name + "Millimetres", FilePlace.Shape, help, preset => Get(group, field, preset),
            value => Put(group, field, FilePlace.Read(value)));

        private static object Get<T>(Group<T> group, FieldInfo field, WingPreset preset) where T : struct => field.GetValue(group(preset));

        private static Action<WingPreset> Put<T>(Group<T> group, FieldInfo field, object value) where T : struct => preset =>
        {
            object whole = group(preset);
            field.SetValue(whole, value);
            group(preset) = (T)whole;
        };

        private static string Camel(string name) => char.ToLowerInvariant(name[0]) + name.Substring(1);
    }
}
