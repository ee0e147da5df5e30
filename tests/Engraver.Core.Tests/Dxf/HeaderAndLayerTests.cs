using System.Text;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Dxf;

public class HeaderAndLayerTests
{
    [Theory]
    [InlineData(1, "in", 25.4)]
    [InlineData(4, "mm", 1.0)]
    [InlineData(8, "uin", 2.54e-5)]
    [InlineData(10, "yd", 914.4)]
    [InlineData(20, "pc", 3.0856775814913673e19)]
    [InlineData(21, "usft", 304.8006096012192)]
    [InlineData(24, "usmi", 1609347.2186944373)]
    public void Insunits_gives_the_unit(int code, string name, double factor)
    {
        var unit = DxfReading.Of(new DxfText().Header("AC1015", code).End()).Unit;

        Assert.Equal((code, name, "INSUNITS"), (unit.Code, unit.Name, unit.Source));
        Assert.Equal(1.0, unit.MillimetresPerUnit / factor, 1e-12);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(25)]
    [InlineData(-4)]
    public void Any_other_insunits_means_millimetres_with_a_warning_that_names_the_way_out(int code)
    {
        var drawing = DxfReading.Of(new DxfText().Section("HEADER", (9, "$INSUNITS"), (70, code), (9, "$MEASUREMENT"), (70, 0)).End());

        Assert.Equal(LengthUnit.AssumedMillimetres, drawing.Unit);
        var message = Assert.Single(drawing.Diagnostics).Message;
        Assert.Contains("$MEASUREMENT is 0", message, StringComparison.Ordinal);
        Assert.Contains("[units-mm]", message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(0, 3, "in", "LUNITS")]
    [InlineData(0, 4, "in", "LUNITS")]
    [InlineData(0, 2, "mm", "assumed")]
    [InlineData(0, 5, "mm", "assumed")]
    [InlineData(5, 4, "cm", "INSUNITS")]
    public void Lengths_shown_in_feet_and_inches_are_inches_where_the_drawing_says_no_unit(int insunits, int lunits, string unit, string source)
    {
        var drawing = DxfReading.Of(new DxfText().Section("HEADER", (9, "$INSUNITS"), (70, insunits), (9, "$LUNITS"), (70, lunits)).End());

        Assert.Equal((unit, source), (drawing.Unit.Name, drawing.Unit.Source));
        Assert.Equal(insunits == 0 ? ["DXF0003"] : [], DxfReading.Ids(drawing));
        if (source == "LUNITS") Assert.Contains($"inches were assumed because $LUNITS is {lunits}", drawing.Diagnostics[0].Message, StringComparison.Ordinal);
    }

    [Fact]
    public void The_operators_unit_wins_without_a_warning()
    {
        var drawing = DxfReading.Of(new DxfText().Header("AC1015", 6).End().ToAscii(), new DxfReadOptions(LengthUnits.FromInsUnits(1)));

        Assert.Equal(("in", "option"), (drawing.Unit.Name, drawing.Unit.Source));
        Assert.Empty(drawing.Diagnostics);
    }

    [Fact]
    public void Layer_switches_are_read_and_names_match_without_regard_to_case()
    {
        var drawing = DxfReading.Of(new DxfText()
            .Section("TABLES", (0, "LAYER"), (2, "Off"), (62, -7), (0, "LAYER"), (2, "Frozen"), (70, 5), (0, "LAYER"), (2, "NoPlot"), (70, 4), (290, 0))
            .Section("ENTITIES", (0, "POINT"), (8, "OFF"), (0, "POINT"), (8, "frozen"), (0, "POINT"), (8, "noplot"), (0, "POINT"), (8, "New"), (0, "POINT"))
            .End());

        Assert.Equal("0++ Off-+ Frozen+- NoPlot++ New++", string.Join(' ', drawing.Layers.Select(layer => layer.Name + (layer.On ? '+' : '-') + (layer.Frozen ? '-' : '+'))));
        Assert.Equal("NoPlot", Assert.Single(drawing.Layers, layer => !layer.Plot).Name);
        Assert.Equal([1, 1, 1, 1, 1], drawing.Balance.RecordsPerLayer);
    }

    [Theory]
    [InlineData("AC1015", "ANSI_1252", 1252, "Größe Ø5")]
    [InlineData("AC1015", "ansi_1251", 1251, "Контур")]
    [InlineData("AC1009", "dos850", 850, "Größe")]
    [InlineData("AC1015", "ANSI_936", 936, "切割层")]
    [InlineData("AC1015", "BIG5", 950, "切割層")]
    [InlineData("AC1009", "ISO8859-2", 28592, "Řez")]
    [InlineData("AC1024", "ANSI_1252", 65001, "Größe 切断 Ω")]
    [InlineData("AC1015", "ANSI_1252", 65001, "Größe 切断 Ω")]
    public void Names_are_read_in_the_encoding_of_the_file(string version, string codePage, int bytesIn, string name)
    {
        var encoding = bytesIn == 65001 ? Encoding.UTF8 : CodePagesEncodingProvider.Instance.GetEncoding(bytesIn) ?? Encoding.GetEncoding(bytesIn);
        var text = Encoding.UTF8.GetString(new DxfText()
            .Section("HEADER", (9, "$ACADVER"), (1, version), (9, "$DWGCODEPAGE"), (3, codePage)).Section("ENTITIES", (0, "POINT"), (8, name)).End().ToAscii());

        Assert.Equal(name, DxfReading.Of(encoding.GetBytes(text)).Layers[1].Name);
    }

    [Fact]
    public void Escaped_characters_are_resolved() => Assert.Equal("Ж香 \\U+12", DxfReading.Entities((0, "POINT"), (8, @"\U+0416\U+9999 \U+12")).Layers[1].Name);

    [Fact]
    public void A_section_plane_among_the_entities_is_no_new_section()
    {
        var drawing = DxfReading.Entities((0, "SECTION"), (5, "A"), (0, "CIRCLE"), (10, 0), (20, 0), (40, 1));

        Assert.Equal((2, 1), (drawing.Balance.Read, drawing.Balance.Cut));
    }

    [Fact]
    public void Unknown_sections_and_a_second_entities_section_are_no_obstacle()
    {
        var drawing = DxfReading.Of(new DxfText()
            .Section("ENTITIES", (0, "POINT")).Section("NOVELTY", (0, "THING"), (10, 0)).Section("EMPTY").Section("ENTITIES", (0, "POINT")).End());

        Assert.Equal((2, "DXF0003"), (drawing.Balance.Points, string.Join(' ', DxfReading.Ids(drawing))));
    }
}
