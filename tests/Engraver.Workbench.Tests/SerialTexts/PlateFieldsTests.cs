using Engraver.Core.Drawings;
using Engraver.Core.Dxf;
using Engraver.Core.Geometry;
using Engraver.TestKit;
using Engraver.Workbench.SerialTexts;

namespace Engraver.Workbench.Tests.SerialTexts;

public class PlateFieldsTests
{
    private static readonly CsvRow s_row = new(3, [new CsvValue("NAME", "Miller"), new CsvValue("CITY", "Rome"), new CsvValue("TEL", "1")]);

    [Fact]
    public void A_drawing_states_its_counters_columns_date_and_copy()
    {
        var fields = PlateFields.Of(Texts("[[n:0000;start=17]]", "[[n:00;step=5]] [[csv:NAME]]", "[[n lot]] [[date]] [[copy]]"));
        Assert.Equal([new CounterDesign("lot", 1, 1), new CounterDesign("n", 17, 5)], fields.Counters);
        Assert.Equal(["NAME"], fields.Columns);
        Assert.True(fields is { UsesDate: true, UsesCopy: true, Any: true });
        Assert.Empty(fields.Findings);
        Assert.False(PlateFields.Of(Texts("plain", "[[")).Any);
    }

    [Fact]
    public void Values_that_no_text_uses_are_left_out()
    {
        var fields = PlateFields.Of(Texts("[[csv:city]]"));
        var values = fields.ValuesOf(s_row, new Dictionary<string, long> { ["n"] = 1 }, DateTimeOffset.UnixEpoch, 1);
        Assert.Equal("csv row 3: CITY=Rome", values.ToString());
        Assert.True(fields.UsesColumnOf(new CsvTable(["CITY"], [s_row])));
        Assert.False(fields.UsesColumnOf(new CsvTable(["NAME"], [s_row])));
    }

    [Fact]
    public void The_tag_of_an_attribute_uses_a_column_if_its_text_has_no_field()
    {
        var (plain, filled) = (Tagged("your name", "name"), Tagged("[[n]]", "CITY"));
        var fields = PlateFields.Of([plain, filled]);
        Assert.False(PlateFields.Of([plain]).Any);
        Assert.True(fields.UsesColumnOf(new CsvTable(["NAME"], [s_row])));
        Assert.Equal([new CsvValue("NAME", "Miller")], fields.Used(s_row).Columns);
        Assert.Equal("SER0002", Assert.Single(PlateFields.Of([plain]).Check(new PlateValues { Row = new CsvRow(1, [new CsvValue("NAME", "")]) })).Id);
    }

    [Fact]
    public void Rows_are_selected_by_ranges_and_lists()
    {
        Assert.Equal([3, 4, 5], CsvRows.Read("3-5", 9));
        Assert.Equal([8, 9], CsvRows.Read("8-", 9));
        Assert.Equal([7, 1, 2], CsvRows.Read("7,1-2", 9));
        Assert.All((string[])["", "0", "3-2", "10", "8-10", "1,1", "a", "-3", "1-2-3", "99999999999"], text => Assert.Null(CsvRows.Read(text, 9)));
    }

    [Fact]
    public void Cells_follow_along_X_and_then_along_Y()
    {
        var grid = new PlateGrid(2, 2, new Vector2D(70, -25));
        Assert.Equal([new(0, 0), new(70, 0), new(0, -25), new(70, -25), new(0, 0)], Enumerable.Range(0, 5).Select(grid.OffsetOf));
        var staggered = grid with { Stagger = new Vector2D(5, -3) };
        Assert.Equal([new(0, 0), new(70, -3), new(5, -25), new(75, -28)], Enumerable.Range(0, 4).Select(staggered.OffsetOf));
        var series = new PlateSeries(PlateFields.Of([]), new CsvRow?[9], grid);
        Assert.Equal([4, 8], Enumerable.Range(0, 9).Where(series.StartsBlank));
    }

    [Fact]
    public void A_plate_survives_its_record()
    {
        var plate = new Plate(3, new PlateValues { Copy = 3 }, new Vector2D(70, -25));
        Assert.Equal(plate, Plate.FromJson(plate.ToJson()));
        Assert.Equal("copy=3 at 70,-25", plate.ToString());
        Assert.All((string[])["", "{}", "null", "[]"], text => Assert.Throws<FormatException>(() => Plate.FromJson(text)));
    }

    [Fact]
    public void The_date_of_a_plate_has_whole_seconds()
    {
        var values = PlateFields.Of(Texts("[[date:ss]]")).ValuesOf(null, new Dictionary<string, long>(), DateTimeOffset.UnixEpoch.AddMilliseconds(12_999), 1);
        Assert.Equal(DateTimeOffset.UnixEpoch.AddSeconds(12), values.Date);
    }

    [Fact]
    public void Two_designs_of_a_counter_are_an_error_with_its_place()
    {
        var finding = Assert.Single(PlateFields.Of(Texts("[[n:0;step=2]]", "[[n:0;step=3]]")).Check(new PlateValues { Counters = new PlateValues().Counters.Add("n", 1) }));
        Assert.Equal("SER0004", finding.Id);
        Assert.True(finding.Source.Line > 0);
    }

    [Fact]
    public void What_is_missing_is_reported_for_each_text()
    {
        var findings = PlateFields.Of(Texts("[[n]] [[csv:NAME]]", "[[x:1]] [[", "[[date]]")).Check(new PlateValues { Row = new CsvRow(1, [new CsvValue("OTHER", "1")]) });
        Assert.Equal(["SER0002", "SER0002", "SER0001", "SER0003", "SER0002"], findings.Select(finding => finding.Id));
        Assert.Contains("OTHER", findings[1].Message, StringComparison.Ordinal);
    }

    private static PlacedText Tagged(string raw, string tag)
    {
        var text = Texts(raw).Single();
        return text with { Written = text.Written with { Tag = tag } };
    }

    private static IEnumerable<PlacedText> Texts(params string[] strings)
    {
        var text = DxfText.WithEntities([.. strings.SelectMany(raw => ((int, object)[])[(0, "TEXT"), (8, "0"), (10, 0.0), (20, 0.0), (40, 2.5), (1, raw)])]);
        return DxfReader.Read(text.ToAscii(), "plate.dxf", DxfReadOptions.Default, CancellationToken.None).Texts;
    }
}
