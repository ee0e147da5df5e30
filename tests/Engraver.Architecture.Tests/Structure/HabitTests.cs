using System.Text.RegularExpressions;
using Engraver.Architecture.Tests.Sources;

namespace Engraver.Architecture.Tests.Structure;

/// <summary>Rules that a compiler does not enforce.</summary>
public class HabitTests
{
    [Theory]
    [MemberData(nameof(ProjectArrowTests.Projects), MemberType = typeof(ProjectArrowTests))]
    public void No_static_can_be_assigned_again(string project)
    {
        using var assembly = BuiltAssembly.Open(project);
        if (assembly is not null) Assert.Empty(assembly.MutableStatics);
        else Assert.True(project == "Engraver.SoftwarePlatform" && !OperatingSystem.IsLinux(), $"{project} was not built beside the tests.");
    }

    [Fact]
    public void A_static_that_can_be_assigned_again_is_noticed()
    {
        using var ours = BuiltAssembly.FromFile(typeof(HabitTests).Assembly.Location);
        Assert.Equal(["Example.<Assigned>k__BackingField"], ours.MutableStatics);
    }

    [Fact]
    public void No_test_sleeps() => AssertNowhere("tests", @"\b(Thread\.Sleep|Task\.Delay|SpinWait\.SpinUntil)\s*\(");

    /// <summary>A test that returns early because something is missing looks like a passed test. It must be skipped by an attribute that states the reason
    /// (CorpusFactAttribute).</summary>
    [Fact]
    public void No_test_returns_green_where_the_corpus_is_missing() => AssertNowhere("tests", @"\bCorpus is (not \{ \}|null)[^;]*\breturn;");

    /// <summary>A property that is checked inside another test does not use the seed of the run (PropertySeedAttribute).</summary>
    [Fact]
    public void No_property_is_checked_inside_another_test() => AssertNowhere("tests", @"\b(QuickCheck\w*|VerboseCheck\w*|Check\.(One|Quick|Verbose|Method)\w*|Config\.(Quick|Verbose)\w*)\b");

    /// <summary>CHANGELOG.md may name versions.</summary>
    [Fact]
    public void The_version_is_stated_in_one_place()
    {
        var stated = SourceFile.Under("", ".props", ".targets", ".csproj", ".json", ".axaml", ".cmd").Where(file => Regex.IsMatch(file.Text, "<(Assembly|File|Informational|Package)?Version(Prefix)?>")).Select(file => file.Name);
        Assert.Equal(["Directory.Build.props"], stated);
    }

    [Fact]
    public void The_version_stands_in_no_source()
    {
        var version = Regex.Match(SourceFile.Read(Path.Combine(TestKit.RepositoryFolder.Root, "Directory.Build.props")).Text, "<Version>(.+?)</Version>").Groups[1].Value;
        Assert.Matches(@"^\d+\.\d+\.\d+$", version);
        AssertNowhere("src", $@"(?<![\d.]){Regex.Escape(version)}(?![\d.])", code: false);
    }

    private static void AssertNowhere(string folder, string pattern, bool code = true)
    {
        var places = SourceFile.Under(folder, ".cs").SelectMany(file => Regex.Matches(code ? CSharpText.Parse(file.Text).Code : file.Text, pattern).Select(found => $"{file.Name}({file.LineOf(found.Index)}): {found.Value}")).ToList();
        Assert.True(places.Count == 0, string.Join('\n', places));
    }

    /// <summary>Cases for the test of static fields.</summary>
    private static class Example
    {
        public const int Constant = 1;
        public static readonly int s_fixed = Environment.ProcessId;
        public static int Assigned { get; set; }
        public static int Given { get; } = Environment.ProcessId;
        public static Func<int> Kept => () => Constant;
    }
}
