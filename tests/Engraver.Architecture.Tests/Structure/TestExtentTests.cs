using System.Reflection;
using Engraver.Architecture.Tests.Sources;
using Engraver.TestKit;
using FsCheck.Xunit;

namespace Engraver.Architecture.Tests.Structure;

/// <summary>The subset for a commit must contain every subject and every pair of choices, and only one class may read the switch of the full run.</summary>
public class TestExtentTests
{
    private static readonly string[] s_modes = ["stream", "calls", "program"];

    private static readonly string[] s_links = ["tcp", "serial"];

    [Theory]
    [InlineData(6)]
    [InlineData(10)]
    public void In_turn_every_subject_and_every_pair_of_choices_occurs(int subjects)
    {
        var runs = TestExtent.Rotated(Enumerable.Range(0, subjects).ToArray(), s_modes, s_links).ToList();

        Assert.Equal(Enumerable.Range(0, subjects), runs.Select(run => run.Subject));
        Assert.Equal(s_modes.Length * s_links.Length, runs.Select(run => (run.First, run.Second)).Distinct().Count());
    }

    [Fact]
    public void The_full_run_tries_every_combination_once()
    {
        var runs = TestExtent.Crossed([1, 2, 3, 4], s_modes, s_links).ToList();

        Assert.Equal(24, runs.Count);
        Assert.Equal(24, runs.Distinct().Count());
    }

    [Theory]
    [InlineData(null, 7)]
    [InlineData("", 7)]
    [InlineData("0", 0)]
    [InlineData("200", 200)]
    public void A_number_of_cases_may_be_named(string? text, int expected) => Assert.Equal(expected, TestExtent.Parse("ENGRAVER_HARM_CASES", text, 7));

    [Theory]
    [InlineData("many")]
    [InlineData("1e6")]
    [InlineData("-1")]
    [InlineData("2_000")]
    public void A_number_that_cannot_be_read_is_refused_by_its_name(string text)
    {
        var refused = Assert.Throws<FormatException>(() => TestExtent.Parse("ENGRAVER_HARM_CASES", text, 7));
        Assert.Contains("ENGRAVER_HARM_CASES", refused.Message, StringComparison.Ordinal);
        Assert.Contains(text, refused.Message, StringComparison.Ordinal);
    }

    [FullRunFact]
    public void A_test_of_the_full_run_is_not_among_a_commits() => Assert.True(TestExtent.IsFull);

    [FullRunTheory]
    [InlineData(1)]
    [InlineData(2)]
    public void Nor_is_one_with_data(int row) => Assert.True(TestExtent.IsFull, $"{row}");

    /// <summary>A commit repeats the cases of the commit before, the full run finds new ones.</summary>
    [Theory]
    [InlineData("", false, PropertySeedAttribute.OfCommit)]
    [InlineData("", true, "")]
    [InlineData("(1,3)", true, "(1,3)")]
    [InlineData("(1,3,20)", false, "(1,3,20)")]
    public void The_seed_of_properties_is_that_of_the_run_or_the_named_one(string named, bool full, string seed) => Assert.Equal(seed, PropertySeedAttribute.SeedOf(named, full));

    [Theory]
    [InlineData("7")]
    [InlineData("(1,3,20,4)")]
    [InlineData("(1,-3)")]
    [InlineData("(1,2)")]
    [InlineData("(1,99999999999999999999)")]
    [InlineData("1 3")]
    public void A_seed_that_cannot_be_read_is_refused_by_its_name(string named)
    {
        var refused = Assert.Throws<FormatException>(() => PropertySeedAttribute.SeedOf(named, full: false));
        Assert.Contains("ENGRAVER_REPLAY", refused.Message, StringComparison.Ordinal);
        Assert.Contains(named, refused.Message, StringComparison.Ordinal);
    }

    /// <summary>The property itself is the check: without the seed of the run, or with another one, its first case differs.</summary>
    [Property(MaxTest = 1, StartSize = 100, EndSize = 100)]
    public void A_property_runs_with_the_seed_of_the_run(int first)
    {
        Assert.IsType<PropertySeedAttribute>(Assert.Single(typeof(TestExtentTests).Assembly.GetCustomAttributes<PropertiesAttribute>()));
        if (TestExtent.Replay.Length == 0 && !TestExtent.IsFull) Assert.Equal(-24, first);
    }

    /// <summary>Pictures and a log are output files and do not change the extent.</summary>
    [Fact]
    public void The_extent_is_read_in_one_place()
    {
        const string Reading = "GetEnvironmentVariable(";
        string[] outputs = [Reading + "\"ENGRAVER_PICTURES\"", Reading + "\"ENGRAVER_FUZZ_LOG\"", Reading + "\"ENGRAVER_UPDATE_GOLDEN\"", Reading + "\"PATH\""];
        var readers = SourceFile.Under("tests", ".cs")
            .Where(file => outputs.Aggregate(file.Text, (text, output) => text.Replace(output, "", StringComparison.Ordinal)).Contains(Reading, StringComparison.Ordinal))
            .Select(file => Path.GetFileName(file.Name));

        Assert.Equal(["TestExtent.cs", "TestExtentTests.cs"], readers.Order(StringComparer.Ordinal));
    }
}
