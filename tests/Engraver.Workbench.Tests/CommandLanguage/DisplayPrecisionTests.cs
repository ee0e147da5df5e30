using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Tests.Commands;

namespace Engraver.Workbench.Tests.CommandLanguage;

/// <summary>Lengths and angles as displayed.</summary>
public class DisplayPrecisionTests
{
    [Theory]
    [InlineData(12.345678901234, "12.3457")]
    [InlineData(10.0, "10")]
    [InlineData(-0.00001, "0")]
    [InlineData(123456789.00004, "123456789")]
    [InlineData(2.00005, "2.0001")]
    public void A_length_has_four_decimals_and_no_zeros_behind(double value, string shown) => Assert.Equal(shown, DisplayPrecision.Initial.FormatLength(value));

    [Theory]
    [InlineData("0.1234567891", "0.1235")]
    [InlineData("0.00001234567", "0.00001235")]
    [InlineData("1234567", "1234567")]
    [InlineData("3.123456789,-4.5", "3.1235,-4.5")]
    [InlineData("Through", "Through")]
    [InlineData("1E5", "1E5")]
    [InlineData("12.5.1", "12.5.1")]
    public void A_default_is_shortened_but_never_to_nothing(string standard, string shown) => Assert.Equal(shown, DisplayPrecision.Initial.FormatDefault(standard));

    [Fact]
    public async Task The_system_variables_say_how_many_decimals()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("DIST", "0,0", "1,2", "LUPREC", "1", "AUPREC", "0", "DIST", "0,0", "1,2", "ID", "1.23456,7.0004");

        Assert.Contains("Distance = 2.2361, Angle in XY Plane = 63.43, Delta X = 1, Delta Y = 2", talk.Said, StringComparison.Ordinal);
        Assert.Contains("Distance = 2.2, Angle in XY Plane = 63, Delta X = 1, Delta Y = 2", talk.Said, StringComparison.Ordinal);
        Assert.Contains("X = 1.2     Y = 7", talk.Said, StringComparison.Ordinal);
        Assert.IsType<InputResult.NotAccepted>(await talk.TypeAsync("LUPREC", "9"));
    }

    /// <summary>A picked point is used and journalled with full precision, and echoed with display precision.</summary>
    [Fact]
    public async Task A_click_is_echoed_short_and_taken_whole()
    {
        await using var talk = CommandTestSession.WithDrawing();
        var echoes = new List<string>();
        talk.Session.MessageWritten += (_, message) => echoes.Add(message.Text);
        await talk.TypeAsync("ID");
        await talk.Session.PointAsync(new Point2D(1.0 / 3.0, 2.0 / 3.0), CancellationToken.None);

        Assert.Contains("Specify point: 0.3333,0.6667", echoes);
        Assert.Equal(new Point2D(1.0 / 3.0, 2.0 / 3.0), talk.Session.LastPoint);
        Assert.Contains("0.3333333333333333,0.6666666666666666", talk.Journal.ToString(), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(0.0, "0")]
    [InlineData(1e-16, "0.000001")]
    [InlineData(5.79e-10, "0.000001")]
    [InlineData(0.00088049, "0.000881")]
    [InlineData(0.000000881, "0.000001")]
    [InlineData(0.0123411, "0.0124")]
    [InlineData(12.341, "12.4")]
    public void A_bound_has_three_digits_and_six_places_at_most_and_is_never_rounded_down(double bound, string shown) => Assert.Equal(shown, DisplayPrecision.FormatErrorBound(bound));
}
