using System.Globalization;

namespace Engraver.Simulator.Tests;

/// <summary>The motion record and its CSV (cli contract, --record).</summary>
public class RecordTests
{
    [Fact]
    public async Task The_file_has_a_row_for_every_sample_of_motion_and_every_output_change_at_rest()
    {
        var file = new StringWriter(CultureInfo.InvariantCulture);
        await using (var rig = new SimulatorRig(new SimulatorOptions { CommandCost = TimeSpan.Zero }))
        {
            rig.Controller.Record.AttachCsv(file);
            rig.Pass(1234).Do("SB1", "SB1", "CB1", "OP 5").Pass(10).Do("PRA=-2", "SPA=1000", "BGA").RunToIdle();
        }

        Assert.Equal(
            """
            t,a,b,c,d,outputs
            1.234,0,0,0,0,1
            1.234,0,0,0,0,0
            1.234,0,0,0,0,5
            1.245,0,0,0,0,5
            1.246,-1,0,0,0,5
            1.247,-1,0,0,0,5
            1.248,-2,0,0,0,5
            1.249,-2,0,0,0,5
            1.250,-2,0,0,0,5
            """.ReplaceLineEndings("\n"),
            file.ToString().TrimEnd('\n'));
    }

    [Fact]
    public async Task The_file_is_up_to_date_while_the_controller_runs()
    {
        var file = new StringWriter(CultureInfo.InvariantCulture);
        await using var rig = new SimulatorRig();
        rig.Controller.Record.AttachCsv(file);
        rig.Do("SB1");

        rig.Time.Advance(TimeSpan.FromMilliseconds(5));

        Assert.EndsWith(",1\n", file.ToString());
    }

    [Fact]
    public async Task A_move_from_an_unrecorded_place_begins_with_that_place()
    {
        await using var rig = new SimulatorRig();
        rig.Do("ACA=67107840", "DPA=700", "PRA=100", "BGA").RunToIdle();

        var samples = rig.Controller.Record.Snapshot();

        Assert.Equal((700, 800), (samples[0].A, samples[^1].A));
        Assert.Equal(samples[^1], rig.Controller.Record[rig.Controller.Record.Count - 1]);
    }

    [Fact]
    public async Task An_output_that_changes_in_motion_shows_at_the_next_sample()
    {
        await using var rig = new SimulatorRig();
        rig.Do("PRA=10000", "BGA").Pass(100).Do("SB2").RunToIdle();

        var samples = rig.Controller.Record.Snapshot();

        Assert.Equal(samples.Count, samples.Select(s => s.Sample).Distinct().Count());
        Assert.Equal(2, samples[^1].Outputs);
    }

    /// <summary>Regression: when the file was closed before the controller ended, the last rows were lost, and a tick of the controller then wrote to a closed
    /// file.</summary>
    [Fact]
    public async Task The_end_of_the_controller_completes_and_closes_the_file_while_something_moves_and_nothing_is_written_later()
    {
        var file = new OwnedFile();
        await using var rig = new SimulatorRig();
        rig.Controller.Record.AttachCsv(file);
        rig.Do("JG 1000", "BGA").Pass(500);

        await rig.Controller.DisposeAsync();
        var last = rig.Controller.Record[rig.Controller.Record.Count - 1];
        rig.Pass(500);
        rig.Controller.Record.FlushCsv();

        Assert.True(file.IsClosed);
        Assert.EndsWith(string.Create(CultureInfo.InvariantCulture, $"{last.Seconds:0.000},{last.A},0,0,0,0\n"), file.ToString());
        Assert.True(last.A > 400);
    }

    [Fact]
    public async Task A_full_disk_ends_the_file_and_not_the_controller()
    {
        var file = new OwnedFile();
        await using var rig = new SimulatorRig();
        rig.Controller.Record.AttachCsv(file);
        file.IsFull = true;
        rig.Do("SB1", "PRA=10", "BGA").RunToIdle();
        rig.Time.Advance(TimeSpan.FromMilliseconds(5));

        await rig.Controller.DisposeAsync();

        Assert.Equal((true, "No space left on device"), (file.IsClosed, rig.Controller.RecordFailure?.Message));
    }

    /// <summary>A file that rejects writes after it was closed, like a real one.</summary>
    private sealed class OwnedFile : StringWriter
    {
        public OwnedFile()
            : base(CultureInfo.InvariantCulture)
        {
        }

        public bool IsClosed { get; private set; }

        public bool IsFull { get; set; }

        public override void Flush()
        {
            ObjectDisposedException.ThrowIf(IsClosed, this);
            if (IsFull) throw new IOException("No space left on device");
        }

        protected override void Dispose(bool disposing)
        {
            IsClosed = true;
            base.Dispose(disposing);
        }
    }
}
