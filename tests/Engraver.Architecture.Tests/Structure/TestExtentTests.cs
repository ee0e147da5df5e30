using Engraver.Architecture.Tests.Sources;
using Engraver.TestKit;

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
