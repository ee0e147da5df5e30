using Engraver.Core.Machines;
using Engraver.Workbench.Machines.Origins;

namespace Engraver.Workbench.Machines;

/// <summary>The part of the machine session that remembers the first of two touches, between which the machine is moved.</summary>
public sealed partial class MachineSession
{
    private (MachineHold Of, int? Mark, CountsPoint At)? _touch;

    /// <summary>Where the first of two touches was, by the zero from which the controller counts now; null where there was none.</summary>
    public CountsPoint? FirstTouch => _touch is { } touch && ReferenceEquals(touch.Of, Hold) && touch.Mark == Hold.Memory.Mark ? touch.At : null;

    /// <summary>The place where the machine stands is the first touch.</summary>
    /// <returns>That place, asked of the controller now.</returns>
    /// <exception cref="InvalidOperationException">No controller is connected, or a job runs.</exception>
    /// <exception cref="ControllerException">The link failed.</exception>
    public async Task<CountsPoint> TouchAsync(CancellationToken cancellation)
    {
        await FreeAsync().ConfigureAwait(false);
        if (_watched.Watch is not { } watch || Hold is not { } hold || IsRunning) throw new InvalidOperationException("No controller is connected, or a job runs.");
        var place = _place = await watch.LocateAsync(Profile.Axes, cancellation).ConfigureAwait(false);
        hold.Recognise(place);
        _touch = (hold, hold.Memory.Mark, place.Position);
        return place.Position;
    }

    /// <summary>The two touches are used up.</summary>
    public void ForgetTouch() => _touch = null;
}
