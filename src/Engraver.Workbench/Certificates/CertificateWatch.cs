using Engraver.Core.Machines;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Certificates;

/// <summary>Keeps how the job of the document stands to its certificate, for a list that is drawn often. Looks in the background, once for each job and
/// after a certificate was made.</summary>
/// <remarks>Any thread.</remarks>
public sealed class CertificateWatch
{
    private readonly Lock _guard = new();
    private PreparedJob? _job;
    private CertificateStanding? _found;
    private int _turn;

    /// <summary>Raised after a job's standing is known, on the thread that found it.</summary>
    public event EventHandler? Changed;

    /// <summary>Null while nobody has looked.</summary>
    public CertificateStanding? StandingOf(PreparedJob job)
    {
        lock (_guard) return ReferenceEquals(job, _job) ? _found : null;
    }

    /// <summary>Looks at the certificate of a job.</summary>
    /// <param name="program">Of the job, made fit for the link.</param>
    public Task<CertificateStanding> LookAsync(PreparedJob job, MotionProgram program, CancellationToken cancellation)
    {
        int turn;
        lock (_guard) turn = ++_turn;
        return Task.Run(() => Looked(job, CertificateStanding.OfRun(job, program), turn), cancellation);
    }

    /// <summary>There is no job any more: what was known of the last one is not kept.</summary>
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
            if (turn != _turn) return found; // another job, or another certificate, has been looked at since
            (_job, _found) = (job, found);
        }

        Changed?.Invoke(this, EventArgs.Empty);
        return found;
    }
}
