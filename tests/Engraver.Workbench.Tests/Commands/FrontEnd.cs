using Engraver.Workbench.Machines;

namespace Engraver.Workbench.Tests.Commands;

/// <summary>A front end that lives: it gives the signs that a continuous jog needs.</summary>
internal sealed class FrontEnd(MachineSession machine) : IDisposable
{
    private readonly Timer _beat = new(_ => machine.Hand.Presence.Sign(), null, TimeSpan.Zero, OperatorPresence.Beat / 2);

    public void Dispose() => _beat.Dispose();
}
