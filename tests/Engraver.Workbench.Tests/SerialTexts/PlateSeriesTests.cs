using Engraver.Core.Dxf;
using Engraver.TestKit;
using Engraver.Workbench.SerialTexts;

namespace Engraver.Workbench.Tests.SerialTexts;

public class PlateSeriesTests
{
    private const string Drawing = "plate.dxf";
    private static readonly string[] s_names = ["Ada", "Bob", "Cyd, \"Jr\"", "Dan"];

    [Theory]
    [InlineData(CounterChoice.Again, 2, 2)]
    [InlineData(CounterChoice.Again, 1, 1, 2)]
    [InlineData(CounterChoice.Again, 3, 3)]
    [InlineData(CounterChoice.Next, 1, 2, 1)] // the numbers of both are left out: their order does not matter
    [InlineData(CounterChoice.Next, 0)]
    [InlineData(CounterChoice.Again, 0)]
    public void A_series_begins_with_the_rows_of_unfinished_plates(CounterChoice choice, int first, params int[] rows) =>
        Assert.Equal(first, Series(0, 1, 2, 3).FirstAfter([.. rows.Select((row, place) => Started(row, 10 + place))], choice, Drawing, isSelected: false));

    [Theory]
    [InlineData(CounterChoice.Again, 2, 1)] // not in the order of the numbers
    [InlineData(CounterChoice.Again, 1, 3)]
    [InlineData(CounterChoice.Next, 1, 3)] // row 2 would be engraved twice
    [InlineData(CounterChoice.Again, 7)]
    [InlineData(CounterChoice.Next, 7)]
    public void A_row_that_is_not_in_its_place_is_refused(CounterChoice choice, params int[] rows)
    {
        var refused = Assert.Throws<CounterException>(() => Series(0, 1, 2, 3).FirstAfter([.. rows.Select((row, place) => Started(row, 10 + place))], choice, Drawing, isSelected: false));
        Assert.Equal("SER0028", refused.Finding!.Id);
    }

    [Fact]
    public void Selected_rows_may_leave_the_unfinished_one_out_with_its_number()
    {
        var series = Series(2, 3);
        Assert.Equal(0, series.FirstAfter([Started(1, 10)], CounterChoice.Next, Drawing, isSelected: true));
        Assert.Throws<CounterException>(() => series.FirstAfter([Started(1, 10)], CounterChoice.Next, Drawing, isSelected: false));
        Assert.Equal(0, series.FirstAfter([Started(1, 10)], CounterChoice.Next, "other.dxf", isSelected: false));
        Assert.Throws<CounterException>(() => series.FirstAfter([Started(1, 10)], CounterChoice.Again, Drawing, isSelected: true));
    }

    [Fact]
    public void A_plate_without_a_row_gives_its_number_to_no_row()
    {
        var started = Started(1, 10) with { Values = "n=10" };
        Assert.Throws<CounterException>(() => Series(0, 1).FirstAfter([started], CounterChoice.Again, Drawing, isSelected: false));
        Assert.Equal(0, Series(0, 1).FirstAfter([started], CounterChoice.Next, Drawing, isSelected: false));
    }

    private static PlateSeries Series(params int[] rows) => new(Fields(), [.. rows.Select(Row)], null);

    private static CsvRow Row(int index) => new(index + 1, [new CsvValue("NAME", index < s_names.Length ? s_names[index] : "Zoe"), new CsvValue("TEL", "1")]);

    private static StartedPlate Started(int row, long number)
    {
        var values = Fields().ValuesOf(Row(row), new Dictionary<string, long> { ["n"] = number }, DateTimeOffset.UnixEpoch, 1);
        return new StartedPlate { Id = "a", Numbers = new Dictionary<string, long> { ["N"] = number }, Values = values.ToString(), Drawing = Path.GetFullPath(Drawing), Journal = "journal", Date = DateTimeOffset.UnixEpoch };
    }

    private static PlateFields Fields() => PlateFields.Of(DxfReader.Read(DxfText.WithEntities((0, "TEXT"), (8, "0"), (10, 1.0), (20, 1.0), (40, 5.0), (1, "[[n]] [[csv:NAME]]")).ToAscii(), Drawing, DxfReadOptions.Default, CancellationToken.None).Texts);
}
