using Engraver.Benchmarks.Links;

namespace Engraver.Cli.Tests.Verbs;

public class BenchVerbTests
{
    [Fact]
    public async Task Every_size_has_a_row_for_each_stage_under_one_head()
    {
        var run = await CliRun.RunAsync("bench", "20", "30");
        var lines = run.Out.TrimEnd('\n').Split('\n');

        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.StartsWith("| Entities | Stage |", lines[0], StringComparison.Ordinal);
        Assert.Equal((2 + 8 + 8, 8, 8), (lines.Length, lines.Count(line => line.StartsWith("| 20 |", StringComparison.Ordinal)), lines.Count(line => line.StartsWith("| 30 |", StringComparison.Ordinal))));
    }

    [Theory]
    [InlineData("0")]
    [InlineData("-5")]
    [InlineData("many")]
    public async Task A_size_that_is_no_number_of_lines_is_a_usage_error(string size) => Assert.Equal(ExitCode.Usage, (await CliRun.RunAsync("bench", size)).ExitCode);

    /// <summary>Eight contours, in and out, no loop open, none unresolved.</summary>
    [Fact]
    public async Task Offsets_have_a_row_for_each_contour_side_and_size()
    {
        var run = await CliRun.RunAsync("bench", "offsets", "100", "150");
        var rows = run.Out.TrimEnd('\n').Split('\n')[2..].Select(line => line.Split('|', StringSplitOptions.TrimEntries)).ToList();

        Assert.Equal((ExitCode.Done, 32), (run.ExitCode, rows.Count));
        Assert.All(rows, row => Assert.Equal(("0", "0"), (row[7], row[8])));
        Assert.Equal(ExitCode.Usage, (await CliRun.RunAsync("bench", "offsets", "many")).ExitCode);
    }

    [Fact]
    public async Task Every_target_of_a_drawing_is_posted_and_verified()
    {
        using var folder = new TemporaryFolder();
        File.Copy(SampleDrawing.PathOf("paper-001"), folder.PathOf("part.dxf"));
        var run = await CliRun.RunAsync("bench", "posts", Path.GetDirectoryName(folder.PathOf("part.dxf"))!);
        var lines = run.Out.TrimEnd('\n').Split('\n')[2..];
        var rows = lines.Where(line => line.StartsWith('|')).Select(line => line.Split('|', StringSplitOptions.TrimEntries)).ToList();

        Assert.Equal((ExitCode.Done, ""), (run.ExitCode, run.Error));
        Assert.Equal(rows.Count, lines.Count(line => line.Contains(": slowest ", StringComparison.Ordinal) && line.Contains(" part.dxf ", StringComparison.Ordinal)));
        Assert.Equal(["galil", "galil-calls", "cldata", "agie", "gcode linuxcnc", "gcode grbl", "hpgl", "xps-linearc", "xps-spline", "xps-pvt"], rows.Select(row => row[1]));
        Assert.All(rows, row => Assert.Equal(("1", "0", "1", "1"), (row[2], row[3], row[7], row[8])));
        Assert.Equal("certificate stands", run.Out.Split('\n')[0].Split('|', StringSplitOptions.TrimEntries)[8]);
        Assert.Equal(ExitCode.Usage, (await CliRun.RunAsync("bench", "posts", folder.PathOf("nowhere"))).ExitCode);
        var one = await CliRun.RunAsync("bench", "posts", Path.GetDirectoryName(folder.PathOf("part.dxf"))!, "--target", "hpgl");
        Assert.Equal("hpgl", Assert.Single(one.Out.TrimEnd('\n').Split('\n')[2..], line => line.StartsWith('|')).Split('|', StringSplitOptions.TrimEntries)[1]);
    }

    /// <summary>A drawing that ends in the middle is damaged: its program is written without a valid certificate, and the line below states this.</summary>
    [Fact]
    public async Task A_program_without_a_certificate_is_named_with_the_reason()
    {
        using var folder = new TemporaryFolder();
        var text = await File.ReadAllTextAsync(SampleDrawing.PathOf("paper-001"));
        var part = folder.WithFile("part.dxf", text[..text.LastIndexOf("ENDSEC", StringComparison.Ordinal)]);
        var run = await CliRun.RunAsync("bench", "posts", Path.GetDirectoryName(part)!, "--target", "hpgl", "--each");
        var lines = run.Out.TrimEnd('\n').Split('\n')[2..];

        Assert.Equal(("1", "0", "0", "0"), lines[^3].Split('|', StringSplitOptions.TrimEntries) is var row ? (row[2], row[3], row[7], row[8]) : default);
        Assert.StartsWith("| hpgl part.dxf | 1 | 0 |", lines[0], StringComparison.Ordinal);
        Assert.Contains("no certificate", lines[^2], StringComparison.Ordinal);
        Assert.Contains("damaged drawing", lines[^2], StringComparison.Ordinal);
    }

    /// <summary>Times are not checked: every fault has its row, and with a working link the stop was sent.</summary>
    [Fact]
    public async Task A_stop_is_measured_under_the_faults_that_are_asked_for()
    {
        var run = await CliRun.RunAsync("bench", "stop", "--presses", "1", "--fault", "dropReply", "--fault", "reset");

        Assert.True(run.ExitCode == ExitCode.Done, run.Error);
        var rows = run.Out.TrimEnd('\n').Split('\n')[2..].Select(line => line.Split('|', StringSplitOptions.TrimEntries)).ToList();
        Assert.Equal(["dropReply", "reset"], rows.Select(row => row[1]));
        Assert.Equal(("1", "0"), (rows[0][2], rows[0][4]));
        Assert.Equal("1", rows[1][2]);
    }

    /// <summary>The time of the current line is at most the whole time, and the following bytes include at least CB 1 and STS.</summary>
    [Fact]
    public async Task A_stop_is_measured_on_a_serial_line_and_behind_the_line_under_way()
    {
        var run = await CliRun.RunAsync("bench", "stop", "--serial", "115200", "--presses", "1", "--fault", "none");

        Assert.True(run.ExitCode == ExitCode.Done, run.Error);
        var lines = run.Out.TrimEnd('\n').Split('\n');
        var row = lines[2].Split('|', StringSplitOptions.TrimEntries);
        Assert.Equal((lines[0].Split('|').Length, "none", "1", "0", "0"), (row.Length, row[1], row[2], row[3], row[4]));
        Assert.InRange(Number(row[9]), 0.7, Number(row[5]));
    }

    [Fact]
    public async Task A_stop_is_measured_with_the_chosen_driver_of_the_serial_device()
    {
        var run = await CliRun.RunAsync("bench", "stop", "--serial", "115200", "--driver", "ports", "--presses", "1", "--fault", "none");
        var row = run.Out.TrimEnd('\n').Split('\n')[^1].Split('|', StringSplitOptions.TrimEntries);

        Assert.Equal((ExitCode.Done, "none", "1", "0"), (run.ExitCode, row[1], row[2], row[4]));
    }

    /// <summary>Times are not checked: every end of a link is reported with both drivers, and the device is free again where it still exists.</summary>
    [Fact]
    public async Task Both_drivers_of_serial_devices_have_a_row_for_an_exchange_and_for_each_end()
    {
        var run = await CliRun.RunAsync("bench", "links", "--exchanges", "5", "--rest", "0.1");

        Assert.True(run.ExitCode == ExitCode.Done, run.Error);
        var tables = run.Out.TrimEnd('\n').Split("\n\n").Select(table => table.Split('\n')[2..].Select(line => line.Split('|', StringSplitOptions.TrimEntries)).ToList()).ToList();
        Assert.Equal(["own", "ports"], tables[0].Select(row => row[1]));
        Assert.Equal(12, tables[1].Count);
        Assert.All(tables[1], row => Assert.DoesNotContain("not reported", row[3], StringComparison.Ordinal));
        Assert.All(tables[1], row => Assert.Equal(row[1].Contains("vanishes", StringComparison.Ordinal), row[6].Length == 0));
    }

    [Fact]
    public void A_thread_that_ended_while_switches_are_counted_is_left_out()
    {
        Assert.InRange(LinkBenchmark.ContextSwitches("/proc/self/task/" + Environment.ProcessId)!.Value, 1, long.MaxValue);
        Assert.Null(LinkBenchmark.ContextSwitches("/proc/self/task/0"));
    }

    [Theory]
    [InlineData("links", "--exchanges", "0")]
    [InlineData("links", "--rest", "0")]
    [InlineData("stop", "--driver", "ports")]
    [InlineData("stop", "--driver", "usb", "--serial", "19200")]
    public async Task What_is_no_measurement_of_serial_devices_is_a_usage_error(params string[] args) => Assert.Equal(ExitCode.Usage, (await CliRun.RunAsync(["bench", .. args])).ExitCode);

    [Theory]
    [InlineData("--presses", "0")]
    [InlineData("--fault", "flood")]
    [InlineData("--serial", "300")]
    [InlineData("--serial", "fast")]
    public async Task What_is_no_number_of_presses_and_no_fault_is_a_usage_error(string option, string value) => Assert.Equal(ExitCode.Usage, (await CliRun.RunAsync("bench", "stop", option, value)).ExitCode);

    [Fact]
    public async Task Trajectories_are_measured_on_every_shape_and_no_deviation_is_beyond_its_bound()
    {
        var run = await CliRun.RunAsync("bench", "trajectories", "--curves", "1");
        var rows = run.Out.Split('\n').Where(line => line.Split('|').Length == 11).Skip(2).Select(line => line.Split('|')).ToList();

        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.Equal(18, rows.Count);
        Assert.All(rows, row => Assert.InRange(Number(row[7]), 1e-4, Number(row[6])));
        Assert.All(rows, row => Assert.InRange(Number(row[6]), 0.0, Number(row[2])));
        Assert.All(rows, row => Assert.True(Number(row[4]) > Number(row[2]), "The plug-in breaks the error on each of these shapes."));
        Assert.Contains("| 1 | 0 |", run.Out, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("0")]
    [InlineData("many")]
    public async Task What_is_no_number_of_curves_is_a_usage_error(string curves) => Assert.Equal(ExitCode.Usage, (await CliRun.RunAsync("bench", "trajectories", "--curves", curves)).ExitCode);

    private static double Number(string cell) => double.Parse(cell, System.Globalization.CultureInfo.InvariantCulture);
}
