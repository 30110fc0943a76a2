using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using System.Text.RegularExpressions;

namespace Alate.Tests.Shaders;

/// <summary>
/// Text of a pass of Alate/Wing as a vertex shader of WebGL 2: glslang's preprocessor resolves includes and macros, functions that neither
/// stage calls are left out, and the words of HLSL become those of GLSL. For the passes of motion vectors, whose two stages both run for
/// each vertex.
/// </summary>
internal static class VertexGlsl
{
    private const string k_Head = """
        #version 300 es
        precision highp float;
        precision highp sampler2D;
        #define mul(a, b) ((a) * (b))
        #define lerp mix

        """;

    /// <summary>Translates a pass.</summary>
    /// <param name="file">File with its program.</param>
    /// <param name="includes">Folders of what it includes.</param>
    /// <param name="macros">Keywords and versions.</param>
    public static string Of(string file, IEnumerable<string> includes, IEnumerable<string> macros)
    {
        var items = Items(Preprocessed(file, includes, macros)).ToList();
        HashSet<string> used = ["Vertex", "Fragment"];
        for (int before = 0; before != used.Count;)
        {
            before = used.Count;
            foreach (string item in items.Where(item => Names(item).Any(used.Contains)))
                used.UnionWith(Regex.Matches(item, @"\w+").Select(word => word.Value));
        }

        var text = new StringBuilder(k_Head);
        foreach (string item in items.Where(item => Names(item).Any(used.Contains)))
            text.AppendLine(Translated(item));
        return text.Append(Entry(text.ToString())).ToString();
    }

    private static string Preprocessed(string file, IEnumerable<string> includes, IEnumerable<string> macros)
    {
        string[] options = ["-E", "-D", "-S", "vert", "-e", "Vertex", .. includes.Select(folder => "-I" + folder)];
        IEnumerable<string> defined = macros.Select(macro => "-D" + (macro.Contains('=') ? macro : macro + "=1"));
        (int code, string text) = InstalledProgram.Run(Glslang.Path, [.. options, .. defined, file]);
        return code == 0 ? Regex.Replace(text, "(?m)^#.*$", "") : throw new InvalidOperationException(text);
    }

    // What stands beside each other at the top: functions end with a brace, all else with a semicolon.
    private static IEnumerable<string> Items(string text)
    {
        int depth = 0, first = 0;
        for (int k = 0; k < text.Length; k++)
        {
            depth += text[k] == '{' ? 1 : text[k] == '}' ? -1 : 0;
            bool isBody = depth == 0 && text[k] == '}' && Regex.IsMatch(text[first..k], @"^[^{]*\)\s*(:\s*\w+\s*)?\{");
            if (depth != 0 || (text[k] != ';' && !isBody))
                continue;
            string item = text[first..(k + 1)].Trim();
            first = k + 1;
            if (item.Length > 1)
                yield return item;
        }
    }

    private static IEnumerable<string> Names(string item)
    {
        Match function = Regex.Match(item, @"^\w+\s+(\w+)\s*\(");
        if (function.Success)
            return [function.Groups[1].Value];
        return Regex.Matches(item, @"(\w+)\s*(?:\[\d+\])?\s*[;,]|^struct\s+(\w+)")
            .Select(match => match.Groups[1].Value + match.Groups[2].Value);
    }

    private static string Translated(string item)
    {
        bool isGlobal = Regex.IsMatch(item, @"^(float|half|bool)\w*\s+[\w\s,\[\]]+;$");
        string text = Regex.Replace(item, @"\s*:\s*[A-Z][A-Za-z]*_?[A-Za-z]*\d*(?=\s*[;{])", "");
        text = Regex.Replace(text, @"=\s*\(\w+\)\s*0\b", "");
        text = Regex.Replace(text, @"(\w+)\s*\.\s*SampleLevel\s*\(\s*\w+\s*,", "textureLod($1,");
        text = Regex.Replace(text, @"(?<![\w.\[])(\d+)(?![\w.\]])", "$1.0");
        text = Regex.Replace(text, @"\b(?:float|half)([234])x\1\b", "mat$1");
        text = Regex.Replace(text, @"\b(?:float|half)([234])\b", "vec$1");
        text = Regex.Replace(text, @"\bhalf\b", "float");
        text = Regex.Replace(text, @"\bstatic\s+", "");
        text = Regex.Replace(text, @"^Texture2D\b", "uniform sampler2D");
        if (text.StartsWith("SamplerState", StringComparison.Ordinal))
            return "";
        Match instanced = Regex.Match(
            text, @"^cbuffer\s+\w+\s*\{\s*(struct\s+(\w+)\s*\{.*?\})\s*(\w+\s*\[\d+\]);", RegexOptions.Singleline);
        if (instanced.Success)
            return $"{instanced.Groups[1].Value};\nuniform {instanced.Groups[2].Value} {instanced.Groups[3].Value};";
        Match buffer = Regex.Match(text, @"^cbuffer\s+\w+\s*\{(.*)\}\s*;?$", RegexOptions.Singleline);
        if (buffer.Success)
            return Regex.Replace(buffer.Groups[1].Value, @"(?m)^\s*(?=\w)", "uniform ");
        return isGlobal ? "uniform " + text : text;
    }

    private static string Entry(string text)
    {
        bool baked = Regex.IsMatch(text, @"\bvec2 baked\b"), instanced = Regex.IsMatch(text, @"\buint instanceID\b");
        return $$"""
            layout(location = 0) in vec3 aPosition;
            layout(location = 1) in vec4 aDisplacement;
            layout(location = 2) in vec2 aBaked;
            out vec4 shown;
            out vec2 motion;
            void main() {
                Attributes corner;
                corner.position = vec4(aPosition, 1.0);
                corner.last = vec3(9.0);
                corner.displacement = aDisplacement.xyz;
                {{(baked ? "corner.baked = aBaked;" : "")}}
                {{(instanced ? "corner.instanceID = 0u;" : "")}}
                Varyings varied = Vertex(corner);
                gl_Position = varied.position;
                shown = varied.now;
                motion = Fragment(varied).xy;
            }
            """;
    }
}
