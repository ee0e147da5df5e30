using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.Machines.Origins;

namespace Engraver.Workbench.Tests.Machines.Origins;

/// <summary>The stored state of a machine is restored unchanged, is leased by one host at a time, and is released whatever fails.</summary>
public sealed class MachineLeaseTests : IDisposable
{
    private const string Address = "tcp://10.0.0.7";
    private static readonly MachineIdentity s_dmc = new("DMC2143", 4);
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("engraver-hold-");

    private string Kept => Directory.GetFiles(_folder.FullName, "*.json").Single();

    [Fact]
    public void What_was_kept_comes_back_whole()
    {
        var memory = StoredMachineState.Empty.WithOrigin("G54", 20000, -5000, 7).WithOrigin("G57", null, 12, null) with
        {
            Active = "G57", Mark = 815, Clock = 123456.5, RestPosition = new CountsPoint(-3, 4), IsMoving = true, Lost = "a position error of axis A",
        };
        using (var hold = Take()) Assert.Null(hold.Update(_ => memory));

        using var again = Take();
        Assert.Equal(("G57", 815, 123456.5), (again.Memory.Active, again.Memory.Mark, again.Memory.Clock));
        Assert.Equal((new CountsPoint(-3, 4), true, "a position error of axis A"), (again.Memory.RestPosition, again.Memory.IsMoving, again.Memory.Lost));
        Assert.Equal(memory.Origins.OrderBy(origin => origin.Key), again.Memory.Origins.OrderBy(origin => origin.Key));
    }

    [Fact]
    public void An_assumed_origin_is_still_assumed_when_it_comes_back()
    {
        using (var hold = Take()) hold.Update(memory => memory.AssumeZero());

        using var again = Take();
        Assert.Equal(new WorkOrigin(0, 0) { IsAssumed = true }, again.Memory.ActiveOrigin);
    }

    [Fact]
    public void A_machine_that_is_taken_is_told_by_its_holder_and_free_when_it_is_let_go()
    {
        using (Take(holder: "engraver (process 7)"))
        {
            Assert.Contains("in use by engraver (process 7)", Assert.Throws<MachineInUseException>(() => Take()).Message, StringComparison.Ordinal);
            File.Delete(Directory.GetFiles(_folder.FullName, "*.holder").Single());
            Assert.Contains("in use by another program", Assert.Throws<MachineInUseException>(() => Take()).Message, StringComparison.Ordinal);
        }

        using var free = Take();
        Assert.True(free.IsPersistent);
    }

    /// <summary>A jog that was released before its start, or a refused job, does not make the position uncertain; a lost link does.</summary>
    [Fact]
    public void A_move_that_ended_before_anything_was_sent_leaves_what_is_known_of_the_machine()
    {
        using var hold = Take(serial: 4711);
        hold.Update(memory => memory with { Mark = 815, Clock = 1.0, RestPosition = new CountsPoint(3, 4) });
        hold.CompareZero(new ControllerPosition(new CountsPoint(3, 4), 4711, 815, 2.0));
        hold.NoteMoving();
        Assert.True(hold.Memory.IsMoving);

        Assert.Null(hold.NoteMotionEnd(JobResult.NotStarted(0, "Let go.")));
        Assert.Equal((true, false, new CountsPoint(3, 4)), (hold.IsZeroKnown, hold.Memory.IsMoving, hold.Memory.RestPosition));
        hold.NoteMoving();
        hold.NoteMotionEnd(JobResult.NotStarted(0, "The link is lost.") with { IsEndKnown = false });
        Assert.Equal((false, true, null), (hold.IsZeroKnown, hold.Memory.IsMoving, hold.Memory.RestPosition));
    }

    [Theory]
    [InlineData("\"x\": 1,", "\"x\": 11,", true)]
    [InlineData("\"moving\": false", "\"moving\": true", true)]
    [InlineData("  ", " ", false)]
    public void A_record_that_was_changed_after_it_was_written_is_refused(string then, string now, bool isRefused)
    {
        using (var hold = Take()) hold.Update(memory => memory.WithOrigin("G54", 1, 2, null));
        var text = File.ReadAllText(Kept);
        Assert.Contains(then, text, StringComparison.Ordinal);
        File.WriteAllText(Kept, text.Replace(then, now, StringComparison.Ordinal));

        if (isRefused) Assert.Contains("checksum mismatch", Assert.Throws<MachineMemoryException>(() => Take()).Message, StringComparison.Ordinal);
        else using (var read = Take()) Assert.Equal(new WorkOrigin(1, 2), read.Memory.ActiveOrigin);
    }

    /// <summary>The controller stores the last stop reason of an axis: it is new only if the machine has moved since it came to rest.</summary>
    [Theory]
    [InlineData(3, 4, false, "")]
    [InlineData(900, 4, false, "axis X ")]
    [InlineData(900, 800, false, "axis XY ")]
    [InlineData(3, 4, true, "axis XY ")]
    public void Steppers_that_were_stopped_without_a_ramp_since_the_last_rest_are_lost(int x, int y, bool wasMoving, string lost)
    {
        using var hold = Take(serial: 4711);
        hold.Update(memory => memory.WithOrigin("G54", 0, 0, null) with { Mark = 815, Clock = 1.0, RestPosition = wasMoving ? null : new CountsPoint(3, 4), IsMoving = wasMoving });

        hold.CompareZero(new ControllerPosition(new CountsPoint(x, y), 4711, 815, 2.0) { Letters = "AB", WithoutEncoder = "AB", StoppedWithoutRamp = "AB" });

        Assert.Equal(lost.Length > 0, hold.Memory.Lost.Length > 0);
        Assert.Contains(lost, hold.Memory.Lost, StringComparison.Ordinal);
    }

    [Fact]
    public void A_servo_that_was_stopped_without_a_ramp_keeps_its_place()
    {
        using var hold = Take(serial: 4711);
        hold.Update(memory => memory.WithOrigin("G54", 0, 0, null) with { Mark = 815, Clock = 1.0, RestPosition = new CountsPoint(3, 4) });

        hold.CompareZero(new ControllerPosition(new CountsPoint(900, 4), 4711, 815, 2.0) { Letters = "AB", WithoutEncoder = "B", StoppedWithoutRamp = "AB" });

        Assert.Equal("", hold.Memory.Lost);
    }

    [Fact]
    public void A_machine_that_was_homed_and_has_no_origin_is_lost_too()
    {
        var homing = new Engraver.Core.Machines.Moves.AxisHoming();
        var profile = MachineProfile.Default with { Axes = MachineProfile.Default.Axes with { X = MachineProfile.Default.Axes.X with { Homing = homing }, Y = MachineProfile.Default.Axes.Y with { Homing = homing } } };
        using var hold = Take(serial: 4711);
        hold.Update(memory => memory.Homed(profile, null) with { Mark = 815, Clock = 1.0, RestPosition = new CountsPoint(3, 4) });
        var place = new ControllerPosition(new CountsPoint(3, 4), 4711, 815, 2.0) { Letters = "AB", WithoutEncoder = "AB" };
        hold.CompareZero(place);
        Assert.True(hold.IsHomed(profile));

        hold.CompareZero(place with { Doubt = "stepper motors are off and do not hold their position: X" });
        hold.CompareZero(place);

        Assert.False(hold.IsHomed(profile));
    }

    [Theory]
    [InlineData("null", "it contains null")]
    [InlineData("[]", "line 1 is not valid JSON")]
    [InlineData("{\"active\":\"G60\"}", "'G60' is not a work origin")]
    [InlineData("{\"origins\":{\"G1\":{\"x\":1}}}", "'G1' is not a work origin")]
    [InlineData("{\"active\":\"G54\",\"origins\":null}", "origins")]
    [InlineData("{\"active\":null,\"origins\":{}}", "active")]
    [InlineData("{\"active\":\"G54\",\"origins\":{\"G54\":null}}", "it contains null")]
    [InlineData("{\"origins\":{\"G54\":{\"x\":1},\"g54\":{\"x\":2}}}", "it contains G54 twice")]
    public void A_file_that_is_no_record_is_named_left_as_it_is_and_not_held(string text, string why)
    {
        using (var hold = Take()) hold.Update(memory => memory with { Mark = 1 });
        var file = Kept;
        File.WriteAllText(file, text);

        var refused = Assert.Throws<MachineMemoryException>(() => Take());
        Assert.Contains(file, refused.Message, StringComparison.Ordinal);
        Assert.Matches($@"\): .*{why}.*\. Repair or delete the file\.", refused.Message);
        Assert.Equal(text, File.ReadAllText(file));
        File.Delete(file);
        using var free = Take();
        Assert.Null(free.Memory.ActiveOrigin);
    }

    [Theory]
    [InlineData("{}", null)]
    [InlineData("{\"active\":\"G55\"}", null)]
    [InlineData("{\"origins\":{\"g54\":{\"x\":1,\"y\":2}}}", 1)]
    public void What_a_record_leaves_out_is_unknown(string text, int? x)
    {
        using (var hold = Take()) hold.Update(memory => memory with { Mark = 1 });
        File.WriteAllText(Kept, text);

        using var read = Take();
        Assert.Equal((x, false), (read.Memory.ActiveOrigin?.X, read.Memory.IsMoving));
        Assert.Equal(text.Contains("G55", StringComparison.Ordinal) ? "G55" : "G54", read.Memory.Active);
    }

    [Fact]
    public void A_file_that_cannot_be_read_is_named_and_the_machine_is_not_held()
    {
        using (var hold = Take()) hold.Update(memory => memory.WithOrigin("G54", 1, 2, null));
        using (new FileStream(Kept, FileMode.Open, FileAccess.ReadWrite, FileShare.None))
        {
            Assert.Contains(Kept, Assert.Throws<MachineMemoryException>(() => Take()).Message, StringComparison.Ordinal);
        }

        using var free = Take();
        Assert.Equal(new CountsPoint(1, 2), free.Memory.ActiveOrigin?.Plane);
    }

    [Fact]
    public void What_cannot_be_written_is_told_and_what_stood_there_stays()
    {
        using var hold = Take();
        hold.Update(memory => memory.WithOrigin("G54", 1, 2, null));
        var file = Kept;
        File.Delete(file);
        Directory.CreateDirectory(file);

        var failure = hold.Update(memory => memory.WithOrigin("G54", 3, 4, null));

        Assert.NotNull(failure);
        Assert.False(failure.EndsWith('.'));
        Assert.True(Directory.Exists(file));
        Assert.Equal(3, Directory.GetFileSystemEntries(_folder.FullName).Length); // The blocking folder, the lock and its owner; no temporary file.
        Assert.NotNull(hold.Commit(memory => memory with { Active = "G55" }));
        Assert.Equal("G54", hold.Memory.Active); // A decision that cannot be stored is rejected.

        Directory.Delete(file);
        Assert.Null(hold.Update(memory => memory)); // Known state is written as soon as possible.
        Assert.Contains("\"x\": 3", File.ReadAllText(file), StringComparison.Ordinal);
    }

    [Fact]
    public void A_controller_is_known_by_its_own_number_and_one_without_by_where_it_is_reached()
    {
        using (var hold = Take(serial: 4711)) hold.Update(memory => memory.WithOrigin("G54", 1, 2, null));

        using (var moved = Take("tcp://10.0.0.8", 4711)) Assert.Equal(new CountsPoint(1, 2), moved.Memory.ActiveOrigin?.Plane);
        using (var other = Take(serial: 4712)) Assert.Null(other.Memory.ActiveOrigin);
        using (var nameless = Take()) nameless.Update(memory => memory.WithOrigin("G54", 3, 4, null));
        using (var same = Take()) Assert.Equal(new CountsPoint(3, 4), same.Memory.ActiveOrigin?.Plane);
        using (var elsewhere = Take("tcp://10.0.0.8")) Assert.Null(elsewhere.Memory.ActiveOrigin);
    }

    [Fact]
    public void Of_a_simulated_machine_nothing_is_kept_and_two_hosts_have_one_each()
    {
        var none = new MachineMemories(null);
        using var hold = none.Acquire(Address, s_dmc, new ControllerPosition(default), "a test");
        using var other = none.Acquire(Address, s_dmc, new ControllerPosition(default), "a test");

        Assert.Null(hold.Update(memory => memory.WithOrigin("G54", 1, 2, null)));
        Assert.False(hold.IsPersistent);
        Assert.Equal(new CountsPoint(1, 2), hold.Memory.ActiveOrigin?.Plane);
        Assert.Null(other.Memory.ActiveOrigin);
        Assert.Empty(_folder.GetFileSystemInfos());
    }

    public void Dispose() => _folder.Delete(recursive: true);

    private MachineLease Take(string address = Address, long? serial = null, string holder = "a test") =>
        new MachineMemories(_folder.FullName).Acquire(address, s_dmc, new ControllerPosition(default, serial), holder);
}
