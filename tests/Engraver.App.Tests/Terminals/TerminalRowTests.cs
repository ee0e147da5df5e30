using Engraver.App.Terminals;
using Engraver.Workbench.Machines.Terminals;

namespace Engraver.App.Tests.Terminals;

/// <summary>The rows of the terminal page.</summary>
public class TerminalRowTests
{
    [Fact]
    public void Each_line_has_the_time_of_the_zone_that_is_given()
    {
        var zone = TimeZoneInfo.CreateCustomTimeZone("test", TimeSpan.FromMinutes(345), null, null);

        var rows = TerminalRow.From(new TerminalEntry(new DateTimeOffset(2026, 11, 27, 20, 30, 15, 250, TimeSpan.Zero), null, "TP\nTE"), zone);

        Assert.Equal([("02:15:15.250", "> TP"), ("02:15:15.250", "> TE")], rows.Select(row => (row.Time, row.Text)));
    }
}
