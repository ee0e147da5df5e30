namespace Engraver.Workbench.Commands.Commissioning;

/// <summary>One step of the commissioning. It can be repeated; Enter keeps the current value.</summary>
internal interface ICommissioningStep
{
    /// <summary>Name in the question before the step.</summary>
    string Name { get; }

    /// <returns>False if the step was abandoned: a move was declined, stopped or refused, or something has to be repaired first. Accepted values
    /// remain.</returns>
    /// <exception cref="CommandException">The link or the controller failed.</exception>
    /// <exception cref="OperationCanceledException">Esc, or the operator's stop: values that were not accepted are reverted.</exception>
    Task<bool> RunAsync(CommissionedMachine machine, CancellationToken cancellation);
}
