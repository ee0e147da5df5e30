using System.Globalization;
using Engraver.Workbench.Commands;

namespace Engraver.Workbench.Tests.Commands;

/// <summary>AREA of curves without a closed formula: ellipses and splines are measured numerically.</summary>
public class CurveAreaTests
{
    private const string Ellipse = "0\nELLIPSE\n5\nE1\n8\n0\n10\n50\n20\n40\n30\n0\n11\n20\n21\n0\n31\n0\n40\n0.25\n41\n0\n42\n6.283185307179586\n";

    private const string HalfEllipse = "0\nELLIPSE\n5\nE2\n8\n0\n10\n0\n20\n0\n30\n0\n11\n0\n21\n8\n31\n0\n40\n0.5\n41\n0\n42\n3.141592653589793\n";

    /// <summary>y = x (4 - x) / 4 from 0,0 to 4,0: one span of the second degree.</summary>
    private const string Parabola = "0\nSPLINE\n5\nE3\n8\n0\n70\n8\n71\n2\n72\n6\n73\n3\n40\n0\n40\n0\n40\n0\n40\n1\n40\n1\n40\n1\n10\n0\n20\n0\n10\n2\n20\n2\n10\n4\n20\n0\n";

    [Theory]
    [InlineData("E1", 20.0 * 5.0 * Math.PI)]
    [InlineData("E2", 8.0 * 4.0 * Math.PI / 2.0)]
    [InlineData("E3", 8.0 / 3.0)]
    public async Task An_ellipse_a_half_of_one_and_a_parabola_closed_by_its_chord(string handle, double area)
    {
        await using var talk = new CommandTestSession();
        await File.WriteAllTextAsync(talk.PathOf("curves.dxf"), "0\nSECTION\n2\nENTITIES\n" + Ellipse + HalfEllipse + Parabola + "0\nENDSEC\n0\nEOF\n");
        await talk.TypeAsync("OPEN", talk.PathOf("curves.dxf"), "LUPREC", "8", "AREA", "O", "H", handle, "");
        var line = talk.Said.Split('\n').Single(text => text.StartsWith("Area = ", StringComparison.Ordinal));

        Assert.Equal(area, double.Parse(line["Area = ".Length..line.IndexOf(',', StringComparison.Ordinal)], CultureInfo.InvariantCulture), 1e-5 * area);
    }

    [Fact]
    public async Task A_line_for_the_controller_is_sent_as_the_terminal_sends_it()
    {
        await using var talk = new CommandTestSession();
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCTERMINAL"));
        await talk.TypeAsync("CNCCONNECT", "sim:");

        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCTERMINAL", "MG 6*7"));
        Assert.Contains("42.0000", talk.Said, StringComparison.Ordinal);
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCTERMINAL", "XX"));
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCTERMINAL", "RS")); // Withheld: it would erase programs of others.
    }
}
