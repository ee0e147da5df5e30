using Engraver.Core.Machines;
using Engraver.Galil.Jobs.Execution;
using Engraver.Galil.Language;
using Engraver.Galil.Programs;
using Engraver.Galil.Protocol;
using Engraver.Galil.Sessions;

namespace Engraver.Galil.Jobs;

/// <summary>The last step of every job, at rest: where an axis drives the tool it is raised to clearance height, straight up out of the cut, and then the
/// spindle is switched off (ADR 11).</summary>
/// <remarks>Over the stop handle, because the operator's stop has ended everything else. The tool is not raised when the position of the axes is not
/// known, or a motor cannot move it.</remarks>
internal sealed class ToolRetreat(ControllerSession session, MachineProfile profile)
{
    /// <summary>Polls in which the axis is reported as moving and does not change its height; after these it counts as at rest.</summary>
    private const int MaxStationaryPolls = 100;

    /// <param name="rest">Where the machine is at rest.</param>
    /// <param name="clearance">The clearance height in the controller's own counts; null where it is not known.</param>
    /// <param name="isDoubted">The position is not reliable.</param>
    /// <returns>Where it is at rest now, and a sentence where the tool is still down; empty when it is up, or an output is the tool.</returns>
    /// <exception cref="ControllerException">The link failed.</exception>
    public async Task<(StandstillReport Standstill, string Warning)> RunAsync(StandstillReport rest, int? clearance, bool isDoubted, TimeSpan pollInterval)
    {
        var warning = "";
        if (profile.Height is not null && profile.Axes.Z is { } z && (clearance is not { } goal || profile.IsLower(rest.Position.Z, goal)))
        {
            var (height, reached) = clearance is { } up && !isDoubted ? await RaiseAsync(z, rest.Position.Z, up, pollInterval).ConfigureAwait(false) : (rest.Position.Z, false);
            rest = rest with { Position = rest.Position with { Z = height } };
            if (!reached) warning = Wording.Get("ToolRetreat.NotRaised", profile.Axes.NameOf(z.Letter), height);
        }

        foreach (var command in Subprograms.RestOffCommands(profile)) await SendAsync(command).ConfigureAwait(false);
        return (rest, warning);
    }

    private async Task<(int Height, bool Reached)> RaiseAsync(MachineAxis z, int from, int goal, TimeSpan pollInterval)
    {
        foreach (var command in (string[])[MotionSettings.SpeedOf(z.Letter, profile.RapidSpeed(z)), RapidMove.GoalOf(z, goal), "BG" + z.Letter])
        {
            if (await SendAsync(command).ConfigureAwait(false) is Rejected) return (from, false);
        }

        var height = from;
        for (var stationary = 0; stationary < MaxStationaryPolls; stationary++)
        {
            var look = await session.StopHandle.ReadAsync($"_BG{z.Letter},_RP{z.Letter}", CancellationToken.None).ConfigureAwait(false);
            if (look.Refusal is not null) return (height, false);
            if ((int)look.Values[1] != height) stationary = 0;
            height = (int)look.Values[1];
            if (look.Values[0] == 0.0) break;
            if (pollInterval > TimeSpan.Zero) await Task.Delay(pollInterval, session.Time, CancellationToken.None).ConfigureAwait(false);
        }

        return (height, height == goal);
    }

    private ValueTask<Reply> SendAsync(string command) => session.StopHandle.SendAsync(command, CancellationToken.None);
}
