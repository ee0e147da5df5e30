using System.Text.RegularExpressions;

namespace Engraver.Architecture.Tests.Sources;

/// <summary>A type that a source file declares outside of other types.</summary>
/// <param name="File">The file.</param>
/// <param name="Namespace">Its namespace; empty for none.</param>
/// <param name="Name">The simple name, without type parameters.</param>
/// <param name="Arity">Number of type parameters.</param>
/// <param name="Bases">The simple names of its base types.</param>
public sealed partial record DeclaredType(SourceFile File, string Namespace, string Name, int Arity, IReadOnlyList<string> Bases)
{
    public string Folder => File.Name[..File.Name.LastIndexOf('/')];

    /// <summary>True if the file is named after the type: <c>Name.cs</c>, or <c>Name.axaml.cs</c> beside its view.</summary>
    public bool NamesFile => File.FileName == Name + ".cs" || File.FileName == Name + ".axaml.cs";

    public static IReadOnlyList<DeclaredType> In(SourceFile file)
    {
        var code = CSharpText.Parse(file.Text).Code;
        var space = NamespaceLine().Match(code).Groups[1].Value;
        var outer = Outer(code);
        return [.. Declaration().Matches(outer).Select(found => new DeclaredType(file, space, found.Groups["name"].Value, Arguments(found.Groups["parameters"].Value), BasesOf(outer, found))),
            .. DelegateDeclaration().Matches(outer).Select(found => new DeclaredType(file, space, found.Groups["name"].Value, Arguments(found.Groups["parameters"].Value), []))];
    }

    /// <summary>The code with everything between braces blanked.</summary>
    private static string Outer(string code)
    {
        var depth = 0;
        return string.Concat(code.Select(c =>
        {
            if (c == '}') depth--;
            var shown = depth == 0 ? c : ' ';
            if (c == '{') depth++;
            return shown;
        }));
    }

    private static int Arguments(string parameters) => parameters.Length == 0 ? 0 : parameters.Count(c => c == ',') + 1;

    /// <summary>What follows the colon behind the name and the parameters of the constructor.</summary>
    private static IReadOnlyList<string> BasesOf(string outer, Match declaration)
    {
        var (at, depth) = (declaration.Index + declaration.Length, 0);
        for (; at < outer.Length && !(depth == 0 && outer[at] is ':' or '{' or ';'); at++)
        {
            if (outer[at] == '(') depth++;
            if (outer[at] == ')') depth--;
        }

        if (at == outer.Length || outer[at] != ':') return [];
        var end = outer.IndexOfAny(['{', ';'], at);
        return [.. Word().Matches(outer[at..(end < 0 ? outer.Length : end)]).Select(word => word.Value)];
    }

    [GeneratedRegex(@"^namespace ([\w.]+)", RegexOptions.Multiline)]
    private static partial Regex NamespaceLine();

    [GeneratedRegex(@"\b(?:class|struct|record|interface|enum)\s+(?:struct\s+|class\s+)?(?<name>[A-Z]\w*)(?:<(?<parameters>[^<>()]*)>)?")]
    private static partial Regex Declaration();

    [GeneratedRegex(@"\bdelegate\s+[^();]+?\s(?<name>[A-Z]\w*)(?:<(?<parameters>[^<>()]*)>)?\s*\(")]
    private static partial Regex DelegateDeclaration();

    [GeneratedRegex(@"\b[A-Z]\w*")]
    private static partial Regex Word();
}
