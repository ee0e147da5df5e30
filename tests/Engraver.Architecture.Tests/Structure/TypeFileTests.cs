using System.Text.RegularExpressions;
using Engraver.Architecture.Tests.Sources;

namespace Engraver.Architecture.Tests.Structure;

/// <summary>A type is found by the name of its file, and its name means one type (docs/architecture.md, "Folders").</summary>
public partial class TypeFileTests
{
    /// <summary>Names that more than one type may have: the texts of each project.</summary>
    private static readonly string[] s_shared = ["Wording"];

    private static readonly Lazy<IReadOnlyList<SourceFile>> s_files = new(() => SourceFile.Under("src", ".cs"));

    [Fact]
    public void A_type_that_is_used_outside_its_folder_is_in_a_file_of_its_name() => AssertNone(UsedOutside(s_files.Value));

    [Fact]
    public void A_command_is_in_a_file_of_its_name() => AssertNone(HiddenCommands(s_files.Value));

    [Fact]
    public void No_two_types_have_one_name() => AssertNone(NamedTwice(s_files.Value));

    [Theory]
    [InlineData("namespace P.B; class User { Small one; }", true)]
    [InlineData("using P.A; namespace Q; class User { Small one; }", true)]
    [InlineData("namespace Q; class User { P.A.Small one; }", true)]
    [InlineData("namespace Q; class User { Small one; }", false)]
    [InlineData("using P.A; namespace Q; class User { Large one; } // Small", false)]
    public void A_type_that_is_hidden_in_another_file_is_noticed(string user, bool isFound)
    {
        SourceFile[] files = [new("src/P/A/Large.cs", user.Contains("P.B", StringComparison.Ordinal) ? "namespace P; class Large { } enum Small { A }" : "namespace P.A; class Large { } enum Small { A }"), new("src/P/B/User.cs", user)];
        Assert.Equal(isFound ? ["src/P/A/Large.cs: Small"] : [], UsedOutside(files));
    }

    [Fact]
    public void A_command_that_is_hidden_in_another_file_is_noticed()
    {
        SourceFile[] files = [new("src/P/SmallCommand.cs", "class SmallCommand : ICommand { } class LargeCommand(int x) : Command(x) { }"), new("src/P/Command.cs", "abstract class Command(int x) : ICommand { }")];
        Assert.Equal(["src/P/SmallCommand.cs: LargeCommand"], HiddenCommands(files));
    }

    [Fact]
    public void Two_types_of_one_name_are_noticed()
    {
        SourceFile[] files = [new("src/P/One.cs", "namespace P; record struct One(int X);"), new("src/Q/Two.cs", "namespace Q; delegate void One<T>(T x);"), new("src/Engraver.Simulator/One.cs", "namespace S; class One;")];
        Assert.Equal(["One: src/P/One.cs, src/Q/Two.cs"], NamedTwice(files));
    }

    private static void AssertNone(IEnumerable<string> found)
    {
        var places = found.ToList();
        Assert.True(places.Count == 0, $"{places.Count}:\n{string.Join('\n', places)}");
    }

    /// <summary>The types without those of the back ends of the desktop, of which one is compiled.</summary>
    private static IEnumerable<DeclaredType> Types(IEnumerable<SourceFile> files) =>
        files.Where(file => !file.Name.StartsWith("src/Engraver.App/Platforms/", StringComparison.Ordinal)).SelectMany(DeclaredType.In);

    /// <summary>The name of the type is in the code of a file of another folder that can see its namespace.</summary>
    private static IEnumerable<string> UsedOutside(IReadOnlyList<SourceFile> files)
    {
        var users = files.Select(file => CSharpText.Parse(file.Text).Code).Zip(files, (code, file) => new
        {
            Folder = file.Name[..file.Name.LastIndexOf('/')],
            Names = Name().Matches(code).Select(name => name.Value).ToHashSet(),
            Space = NamespaceLine().Match(code).Groups[1].Value,
            Usings = Using().Matches(code).Select(space => space.Groups[1].Value).ToHashSet(),
            Code = code,
        }).ToList();
        return Types(files).GroupBy(type => (type.Namespace, type.Name, type.Arity)).Where(type => !type.Any(part => part.NamesFile)).Select(type => type.First())
            .Where(type => users.Any(user => user.Folder != type.Folder && user.Names.Contains(type.Name)
                && (user.Usings.Contains(type.Namespace) || IsInside(user.Space, type.Namespace) || user.Code.Contains($"{type.Namespace}.{type.Name}", StringComparison.Ordinal))))
            .Select(type => $"{type.File.Name}: {type.Name}").Distinct();
    }

    private static bool IsInside(string space, string outer) => space == outer || space.StartsWith(outer + ".", StringComparison.Ordinal);

    private static IEnumerable<string> HiddenCommands(IEnumerable<SourceFile> files)
    {
        var types = Types(files).ToList();
        var commands = new HashSet<string> { "ICommand" };
        while (types.Where(type => type.Bases.Any(commands.Contains)).Select(type => commands.Add(type.Name)).ToList().Contains(true))
        {
        }

        return types.Where(type => commands.Contains(type.Name) && type.Bases.Any(commands.Contains) && !type.NamesFile).Select(type => $"{type.File.Name}: {type.Name}");
    }

    /// <summary>Without the simulator, which shares no code with the others. A generic type and its companion in one namespace have one name.</summary>
    private static IEnumerable<string> NamedTwice(IEnumerable<SourceFile> files) =>
        Types(files).Where(type => !type.File.Name.StartsWith("src/Engraver.Simulator/", StringComparison.Ordinal) && !s_shared.Contains(type.Name))
            .GroupBy(type => type.Name).Where(name => name.Select(type => type.Namespace).Distinct().Count() > 1)
            .Select(name => $"{name.Key}: {string.Join(", ", FilesOf(name))}").Order(StringComparer.Ordinal);

    private static IReadOnlyList<string> FilesOf(IEnumerable<DeclaredType> types) => [.. types.Select(type => type.File.Name).Distinct().Order(StringComparer.Ordinal)];

    [GeneratedRegex(@"\b[A-Z]\w*")]
    private static partial Regex Name();

    [GeneratedRegex(@"^namespace ([\w.]+)", RegexOptions.Multiline)]
    private static partial Regex NamespaceLine();

    [GeneratedRegex(@"\busing (?:static )?(?:\w+ = )?([\w.]+);")]
    private static partial Regex Using();
}
