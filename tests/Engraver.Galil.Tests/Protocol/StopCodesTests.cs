using Engraver.Galil.Protocol;

namespace Engraver.Galil.Tests.Protocol;

/// <summary>The reason why an axis stopped, in words (galil-dmc.md A.10).</summary>
public class StopCodesTests
{
    [Theory]
    [InlineData(2, "forward limit switch")]
    [InlineData(3, "reverse limit switch")]
    [InlineData(4, "ST command")]
    [InlineData(6, "abort input")]
    [InlineData(7, "AB command")]
    [InlineData(8, "following error")]
    [InlineData(11, "selective abort")]
    [InlineData(101, "vector sequence ended")]
    public void A_known_code_is_said_in_words(int code, string words) => Assert.Contains(words, StopCodes.Text(code), StringComparison.Ordinal);

    [Theory]
    [InlineData(5)]
    [InlineData(-1)]
    [InlineData(255)]
    public void An_unknown_code_keeps_its_number(int code) => Assert.Equal($"stop code {code}", StopCodes.Text(code));

    [Fact]
    public void No_two_known_codes_are_said_alike()
    {
        int[] known = [0, 1, 2, 3, 4, 6, 7, 8, 11, 100, 101];
        Assert.Equal(known.Length, known.Select(StopCodes.Text).Distinct().Count());
    }
}
