using Engraver.Workbench.Machines;

namespace Engraver.Workbench.Tests.Commands;

/// <summary>A responsive front end, which sends the signals required by a continuous jog.</summary>
internal sealed class FrontEnd(MachineSession machine) : IDisposable
{
    private readonly Timer _beat = new(_ => machine.Hand.Presence.Sign(), null, TimeSpan.Zero, OperatorPresence.SignInterval / 2);

    public void Dispose() => _beat.Dispose();
}
