using Engraver.Core.Machines;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Certificates;

/// <summary>Caches the certificate status of the document's job for a list that is redrawn often. Checks in the background, once for each job and after a
/// certificate was issued.</summary>
/// <remarks>Any thread.</remarks>
public sealed class CertificateWatch
{
    private readonly Lock _guard = new();
    private PreparedJob? _job;
    private CertificateStanding? _found;
    private int _turn;

    /// <summary>Raised when the status of a job is known, on the thread that determined it.</summary>
    public event EventHandler? Changed;

    /// <summary>Null before the first check.</summary>
    public CertificateStanding? StandingOf(PreparedJob job)
    {
        lock (_guard) return ReferenceEquals(job, _job) ? _found : null;
    }

    /// <summary>Checks the certificate of a job.</summary>
    /// <param name="program">The job's program with feeds limited to the link.</param>
    public Task<CertificateStanding> LookAsync(PreparedJob job, MotionProgram program, CancellationToken cancellation)
    {
        int turn;
        lock (_guard) turn = ++_turn;
        return Task.Run(() => Looked(job, CertificateStanding.OfRun(job, program), turn), cancellation);
    }

    /// <summary>Discards the status: there is no job.</summary>
    public void Forget()
    {
        lock (_guard)
        {
            _turn++;
            (_job, _found) = (null, null);
        }
    }

    private CertificateStanding Looked(PreparedJob job, CertificateStanding found, int turn)
    {
        lock (_guard)
        {
            if (turn != _turn) return found; // Another job, or another certificate, was checked meanwhile.
            (_job, _found) = (job, found);
        }

        Changed?.Invoke(this, EventArgs.Empty);
        return found;
    }
}
