using System.Globalization;
using System.Text.Json;
using Engraver.Core.EntityTables;
using Engraver.TestKit;

namespace Engraver.Core.Tests.EntityTables;

public class EntityTableWriterTests
{
    private const double Awkward = 0.1 + 0.2;

    [Fact]
    public void Json_is_one_object_with_columns_and_rows_that_read_back_exactly()
    {
        using var json = JsonDocument.Parse(Text(EntityTableJson.Write));

        Assert.Equal(16, json.RootElement.GetProperty("columns").GetArrayLength());
        Assert.Equal("s15", json.RootElement.GetProperty("columns")[15].GetString());
        Assert.Equal(Awkward, json.RootElement.GetProperty("rows")[0][1].GetDouble());
    }

    [Fact]
    public void An_empty_table_is_still_valid_json()
    {
        using var text = new StringWriter();
        EntityTableJson.Write(EntityTable.Empty, text);
        using var json = JsonDocument.Parse(text.ToString());

        Assert.Equal(0, json.RootElement.GetProperty("rows").GetArrayLength());
    }

    [Fact]
    public void Minus_zero_is_never_written() =>
        Assert.Equal("1,0.30000000000000004,0,0,1,2,0,0,0,0,0,0,0,0,0,0", Text(EntityTableCsv.Write).Split('\n')[1]);

    [Fact]
    public void Numbers_have_a_point_whatever_the_culture()
    {
        var before = CultureInfo.CurrentCulture;
        CultureInfo.CurrentCulture = new CultureInfo("de-DE") { NumberFormat = { NumberDecimalSeparator = "," } };
        try
        {
            Assert.Contains("0.30000000000000004", Text(EntityTableText.Write), StringComparison.Ordinal);
        }
        finally
        {
            CultureInfo.CurrentCulture = before;
        }
    }

    [Fact]
    public void The_text_table_lines_its_columns_up()
    {
        var lines = Text(EntityTableText.Write).TrimEnd('\n').Split('\n');

        Assert.Equal(2, lines.Length);
        Assert.Equal(lines[0].Length, lines[1].Length);
    }

    private static string Text(Action<EntityTable, TextWriter> write)
    {
        using var text = new StringWriter();
        write(EntityTableBuilder.Build(new DrawingBuilder().Line(Awkward, -0.0, 1, 2).Build(), LayerSelection.Default), text);
        return text.ToString();
    }
}
