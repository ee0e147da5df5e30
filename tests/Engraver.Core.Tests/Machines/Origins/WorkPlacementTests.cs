using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;

namespace Engraver.Core.Tests.Machines.Origins;

/// <summary>The position of a drawing's zero on a machine: taken from the stored origin, refused if unknown, never guessed.</summary>
public class WorkPlacementTests
{
    private static readonly StoredMachineState s_set = StoredMachineState.Empty.WithOrigin("G54", 12500, -3000, null) with { Mark = 77, Clock = 1000, RestPosition = new CountsPoint(40000, 0) };

    [Fact]
    public void The_active_origin_is_where_the_work_is_wherever_the_machine_stands()
    {
        Assert.Equal(new CountsPoint(12500, -3000), Work(s_set, At(40000, 0) with { Mark = 77, Clock = 1000 }).Frame);
        Assert.Equal(new CountsPoint(12500, -3000), Work(s_set, At(-7, 99) with { Mark = 77, Clock = 9999 }).Frame);
        var second = s_set.WithOrigin("G55", 1, 2, null) with { Active = "G55" };
        Assert.Equal(new CountsPoint(1, 2), Work(second, At(0, 0) with { Mark = 77 }).Frame);
    }

    [Theory]
    [InlineData(null, 5000.0)] // the variable is gone: switched off
    [InlineData(78, 5000.0)] // another host's or another session's mark
    [InlineData(77, 999.0)] // burned with BV, but the clock was restarted
    public void After_a_power_cycle_an_origin_that_was_set_is_nowhere_also_where_the_controller_counts_0(int? mark, double clock)
    {
        foreach (var place in new[] { At(0, 0), At(40000, 0) })
        {
            var found = Work(s_set, place with { Mark = mark, Clock = clock });
            Assert.Null(found.Frame);
            Assert.Equal("JOB0009", found.Refusal!.Id);
        }
    }

    /// <summary>Regression: a machine of 800 counts per millimetre, driven with the default profile of 1000, cut its part a quarter too large, and the run was
    /// reported as complete.</summary>
    [Fact]
    public void A_machine_that_was_homed_is_not_driven_with_a_profile_that_knows_no_homing()
    {
        Assert.Equal("JOB0041", Work(s_set with { HomedAs = "A-Switch@0 B-Switch@0" }, At(0, 0) with { Mark = 77, Clock = 1000 }).Refusal!.Id);
        Assert.Equal("JOB0009", Work(s_set with { HomedAs = "A-Switch@0 B-Switch@0" }, At(0, 0)).Refusal!.Id);
    }

    /// <summary>Regression: a profile with other counts was accepted silently.</summary>
    [Fact]
    public void An_origin_belongs_to_the_counts_by_which_it_was_set_and_to_any_where_nobody_knows_them()
    {
        var place = At(0, 0) with { Mark = 77, Clock = 1000 };
        var set = s_set.WithOrigin("G54", 0, 0, 0, new StoredAxes(new StoredAxis(1000, null), new StoredAxis(1000, null), new StoredAxis(400, null))); // Z on a machine whose profile has no such axis
        var other = MachineProfile.Default with { Axes = MachineAxes.FromScale(1000, -1000) };
        PlacementResult Find(StoredMachineState memory, MachineProfile profile) => WorkPlacement.Find(memory, place, new OriginRequest.ActiveOrigin(), profile, default);

        Assert.Equal(default(CountsPoint), Work(set, place).Frame);
        Assert.Equal(["G54", "1000", "Y", "-1000"], Find(set, other).Refusal!.Facts);
        Assert.NotNull(Find(s_set, other).Frame);
        Assert.NotNull(Find(set.WithOrigin("G54", null, 5, null, StoredAxes.Of(other)), other).Frame);
        var used = s_set.UsedBy(other);
        Assert.Equal((new StoredAxes(new StoredAxis(1000, 'A'), new StoredAxis(-1000, 'B'), null), "JOB0042"), (used.ActiveOrigin!.Axes, Work(used, place).Refusal!.Id));
        Assert.Equal(default, StoredMachineState.Empty.AssumeZero().UsedBy(other).ActiveOrigin!.Axes); // 0 is 0 by every profile
    }

    [Fact]
    public void An_origin_belongs_to_the_axes_by_which_it_was_set()
    {
        var place = At(0, 0) with { Mark = 77, Clock = 1000 };
        var axes = MachineProfile.Default.Axes;
        var swapped = MachineProfile.Default with { Axes = axes with { X = axes.X with { Letter = 'B' }, Y = axes.Y with { Letter = 'A' } } };
        var set = s_set.WithOrigin("G54", 0, 0, null, StoredAxes.Of(MachineProfile.Default));

        var refusal = WorkPlacement.Find(set, place, new OriginRequest.ActiveOrigin(), swapped, default).Refusal!;
        Assert.Equal("JOB0046", refusal.Id);
        Assert.Equal(["G54", "X", "A", "B"], refusal.Facts);
        Assert.NotNull(WorkPlacement.Find(set.WithOrigin("G54", 0, 0, null, StoredAxes.Of(swapped)), place, new OriginRequest.ActiveOrigin(), swapped, default).Frame);
        Assert.Equal(new StoredAxis(1000, 'A'), set.UsedBy(MachineProfile.Default).ActiveOrigin!.Axes.X);
    }

    [Fact]
    public void A_machine_that_nobody_zeroed_has_its_origin_where_it_counts_0_and_only_there()
    {
        var first = Work(StoredMachineState.Empty, At(0, 0));
        Assert.Equal((default(CountsPoint), true), (first.Frame!.Value, first.IsAssumed));
        Assert.Equal("JOB0008", Work(StoredMachineState.Empty, At(1, 0)).Refusal!.Id);

        var kept = StoredMachineState.Empty.AssumeZero() with { Mark = 5 };
        Assert.Equal(default(CountsPoint), Work(kept with { RestPosition = new CountsPoint(75000, 0) }, At(75000, 0) with { Mark = 5 }).Frame); // stopped in the middle: the same place again
    }

    [Fact]
    public void After_a_power_cycle_a_machine_that_rested_at_0_is_where_it_was_and_one_that_rested_elsewhere_or_moved_is_refused()
    {
        var kept = StoredMachineState.Empty.AssumeZero() with { Mark = 5, RestPosition = default(CountsPoint) };
        Assert.Equal(default(CountsPoint), Work(kept, At(0, 0)).Frame);
        Assert.Equal("JOB0009", Work(kept with { RestPosition = new CountsPoint(75000, 0) }, At(0, 0)).Refusal!.Id);
        Assert.Equal("JOB0009", Work(kept with { RestPosition = null, IsMoving = true }, At(0, 0)).Refusal!.Id);
        Assert.Equal("JOB0009", Work(kept, At(10, 0)).Refusal!.Id);
    }

    [Fact]
    public void After_a_power_cycle_an_origin_that_was_set_is_lost_also_while_another_one_is_active()
    {
        var kept = StoredMachineState.Empty.WithOrigin("G54", 0, 0, null) with { Active = "G56", Mark = 5, RestPosition = default(CountsPoint) };
        Assert.Equal("JOB0009", Work(kept, At(0, 0)).Refusal!.Id); // a job here would confirm the zero of G54
        Assert.True(Work(kept, At(0, 0) with { Mark = 5 }).IsAssumed);
    }

    /// <summary>The job of the controller checks whether the job itself can be counted from here.</summary>
    [Fact]
    public void The_drawings_zero_may_lie_farther_from_here_than_a_controller_counts() =>
        Assert.Equal(new CountsPoint(int.MinValue + 5L - 1000, 0), WorkPlacement.Find(StoredMachineState.Empty, At(int.MinValue + 5, 0), new OriginRequest.PresentPosition(), MachineProfile.Default, new CountsPoint(1000, 0)).Frame);

    [Fact]
    public void A_position_that_is_in_doubt_is_refused_until_an_origin_is_set_again()
    {
        var marked = At(40000, 0) with { Mark = 77, Clock = 1000 };
        Assert.Contains("stepper", Work(s_set, marked with { Doubt = "the stepper motor of axis A is off" }).Refusal!.Message, StringComparison.Ordinal);
        var lost = s_set with { Lost = "an axis could not follow" };
        Assert.Equal("JOB0010", Work(lost, marked).Refusal!.Id);
        Assert.Null(Work(lost.Forget().WithOrigin("G54", 0, 0, null), marked).Refusal);
    }

    [Fact]
    public void An_origin_with_one_axis_is_none_yet_and_the_sentence_names_the_other()
    {
        var half = StoredMachineState.Empty.WithOrigin("G54", 5, null, null);
        Assert.Contains("no value for Y", Work(half, At(0, 0)).Refusal!.Message, StringComparison.Ordinal);
        Assert.Equal(new CountsPoint(5, 6), Work(half.WithOrigin("G54", null, 6, null), At(0, 0)).Frame);
    }

    [Fact]
    public void Here_takes_the_machines_place_for_the_drawings_start_and_a_given_place_is_machine_millimetres()
    {
        var here = WorkPlacement.Find(s_set, At(10000, 500), new OriginRequest.PresentPosition(), MachineProfile.Default, new CountsPoint(3000, -1000));
        Assert.Equal((new CountsPoint(7000, 1500), OriginSource.Here), (here.Frame!.Value, here.Source));
        var given = WorkPlacement.Find(s_set, At(1, 1), new OriginRequest.MachinePoint(new Point2D(2.5, -1)), MachineProfile.Default, default);
        Assert.Equal((new CountsPoint(2500, -1000), OriginSource.Given), (given.Frame!.Value, given.Source));
        Assert.Equal("JOB0012", WorkPlacement.Find(s_set, At(1, 1), new OriginRequest.MachinePoint(new Point2D(9e9, 0)), MachineProfile.Default, default).Refusal!.Id);
        Assert.Equal("JOB0010", WorkPlacement.Find(s_set, At(1, 1) with { Doubt = "x" }, new OriginRequest.MachinePoint(default), MachineProfile.Default, default).Refusal!.Id);
        Assert.Equal("JOB0010", WorkPlacement.Find(s_set with { Lost = "its steppers were without current" }, At(1, 1), new OriginRequest.MachinePoint(default), MachineProfile.Default, default).Refusal!.Id);
    }

    private static ControllerPosition At(int x, int y) => new(new CountsPoint(x, y));

    [Fact]
    public void On_a_machine_with_a_Z_axis_a_height_that_nobody_set_is_refused_and_never_taken_for_0()
    {
        var tall = MachineProfile.Default with { Axes = MachineAxes.Default with { Z = new MachineAxis('C', 400.0) }, Height = new HeightDrive() };
        PlacementResult Find(StoredMachineState memory, CountsPoint at, OriginRequest? request = null) =>
            WorkPlacement.Find(memory, new ControllerPosition(at) { Mark = 77, Clock = 9999 }, request ?? new OriginRequest.ActiveOrigin(), tall, default);

        Assert.Equal(("JOB0011", true), (Find(s_set, default).Refusal!.Id, Find(s_set, default).Refusal!.Message.Contains('Z', StringComparison.Ordinal)));
        var set = s_set.WithOrigin("G54", null, null, -4000);
        Assert.Equal(new CountsPoint(12500, -3000, -4000), Find(set, new CountsPoint(1, 2, 3)).Frame);
        Assert.Equal(new CountsPoint(1, 2, 3), Find(set, new CountsPoint(1, 2, 3), new OriginRequest.PresentPosition()).Frame);
        Assert.Equal(new CountsPoint(2000, 3000, -4000), Find(set, new CountsPoint(1, 2, 3), new OriginRequest.MachinePoint(new Point2D(2, 3))).Frame);
        Assert.Equal("JOB0011", Find(s_set, new CountsPoint(1, 2, 3), new OriginRequest.MachinePoint(new Point2D(2, 3))).Refusal!.Id);
    }

    [Fact]
    public void A_fresh_controller_that_counts_0_in_three_axes_has_its_zero_there_and_keeps_it()
    {
        var tall = MachineProfile.Default with { Axes = MachineAxes.Default with { Z = new MachineAxis('C', 400.0) }, Height = new HeightDrive() };
        var fresh = WorkPlacement.Find(StoredMachineState.Empty, new ControllerPosition(default), new OriginRequest.ActiveOrigin(), tall, default);
        Assert.Equal((default(CountsPoint), true), (fresh.Frame!.Value, fresh.IsAssumed));
        var refused = WorkPlacement.Find(StoredMachineState.Empty, new ControllerPosition(new CountsPoint(0, 0, 6)), new OriginRequest.ActiveOrigin(), tall, default).Refusal!;
        Assert.Equal("JOB0008", refused.Id);
        Assert.Contains("position is 0, 0, 0.015 mm", refused.Message, StringComparison.Ordinal); // because of the height

        var kept = StoredMachineState.Empty.AssumeZero(hasHeight: true) with { Mark = 5 };
        var later = WorkPlacement.Find(kept, new ControllerPosition(new CountsPoint(0, 0, 2000), Mark: 5), new OriginRequest.ActiveOrigin(), tall, default);
        Assert.Equal(default(CountsPoint), later.Frame);
    }

    [Fact]
    public void A_height_that_nobody_set_is_not_taken_from_where_the_controller_counts_0()
    {
        var tall = MachineProfile.Default with { Axes = MachineAxes.Default with { Z = new MachineAxis('C', 400.0) }, Height = new HeightDrive { ClearanceHeight = 5.0 } };
        var at = new ControllerPosition(new CountsPoint(7, 8, 0), Mark: 77, Clock: 9999);

        Assert.Equal("JOB0032", WorkPlacement.TravelHeight(StoredMachineState.Empty, new ControllerPosition(default), tall).Refusal?.Id);
        Assert.Equal("JOB0032", WorkPlacement.TravelHeight(s_set, at, tall).Refusal?.Id);
        Assert.Equal((2100, null), WorkPlacement.TravelHeight(s_set.WithOrigin("G54", null, null, 100), at, tall));
        Assert.Equal((2000, null), WorkPlacement.TravelHeight(StoredMachineState.Empty.AssumeZero(hasHeight: true) with { Mark = 77 }, at, tall)); // the zero of a job that was run there
        Assert.Equal("JOB0011", WorkPlacement.Find(StoredMachineState.Empty, new ControllerPosition(new CountsPoint(7, 8, 0)), new OriginRequest.MachinePoint(new Point2D(2, 3)), tall, default).Refusal?.Id);
        Assert.Equal(new CountsPoint(2000, 3000, 0), WorkPlacement.Find(StoredMachineState.Empty, new ControllerPosition(default), new OriginRequest.MachinePoint(new Point2D(2, 3)), tall, default).Frame);
    }

    private static PlacementResult Work(StoredMachineState memory, ControllerPosition place) => WorkPlacement.Find(memory, place, new OriginRequest.ActiveOrigin(), MachineProfile.Default, default);
}
